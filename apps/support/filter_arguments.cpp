#include "support/filter_arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "support/program.h"

namespace wardslam::apps {
namespace {

constexpr const char* kGeometricFilter = "wardslam::filters::GeometricMotionFilter";

}  // namespace

void addFilterArguments(CLI::App& command, FilterArguments& arguments) {
  command.add_option("--config", arguments.config, "configuration (YAML); `wardslam config` prints the defaults");
  auto* masks = command.add_option("--masks", arguments.masks,
                                   "folder of recorded masks, one PNG of class ids per colour image, named by stamp");
  command.add_option("--model", arguments.model, "YOLO segmentation network (v5 or v8 layout, ONNX)")->excludes(masks);
  command
      .add_option("--mode", arguments.mode,
                  "tracking waits for the masks of each frame, or takes the newest, carried to the frame")
      ->check(CLI::IsMember({"wait", "propagate"}));
}

pipeline::SlamOptions effectiveOptions(const FilterArguments& arguments, const std::string& program) {
  using Segmenter = segmentation::SegmentationOptions::Type;
  auto options = arguments.config.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(arguments.config);
  if (!arguments.masks.empty()) {
    options.segmentation.type = Segmenter::RecordedMasks;
    options.segmentation.recorded_masks.folder = std::filesystem::absolute(arguments.masks).string();
  }
  if (!arguments.model.empty()) {
    options.segmentation.type = Segmenter::Yolo;
    options.segmentation.yolo.model = std::filesystem::absolute(arguments.model).string();
  }
  options.deterministic = options.deterministic || arguments.deterministic;
  const bool hasMasks = options.segmentation.type != Segmenter::None;
  if (arguments.filter == "on" && !hasMasks) {
    throw UsageError(
        "--filter on needs masks: give --masks DIR, --model FILE.onnx or a configuration with a segmenter");
  }
  if (arguments.filter == "off") {
    options.segmentation.type = Segmenter::None;
    options.filters = pipeline::SlamOptions::noFilters();
  } else if (arguments.filter == "geometric") {
    options.segmentation.type = Segmenter::None;
    options.keepOnlyFilters(kGeometricFilter);
  } else if (!hasMasks && arguments.config.empty()) {
    std::cerr << program << ": without --masks or --model nothing is segmented: what moves is told by geometry alone\n";
    options.keepOnlyFilters(kGeometricFilter);
  }
  if (!arguments.mode.empty() &&
      !options.setFilterParameter("wardslam::filters::SemanticDynamicFilter", "mode", arguments.mode)) {
    throw UsageError("--mode says how the SemanticDynamicFilter gets its masks, but that filter is not in use");
  }
  return options;
}

}  // namespace wardslam::apps
