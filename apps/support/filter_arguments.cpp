#include "support/filter_arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "support/program.h"

namespace wardslam::apps {
namespace {

constexpr const char* kSemanticFilter = "wardslam::filters::SemanticDynamicFilter";
constexpr const char* kGeometricFilter = "wardslam::filters::GeometricMotionFilter";

using Segmenter = segmentation::SegmentationOptions::Type;

/// Where masks are to come from, as far as the command line says.
void chooseSegmenter(const FilterArguments& arguments, pipeline::SegmentationSection& options) {
  if (!arguments.masks.empty()) {
    options.type = Segmenter::RecordedMasks;
    options.recorded_masks.folder = std::filesystem::absolute(arguments.masks).string();
  }
  if (!arguments.model.empty()) {
    options.type = Segmenter::Yolo;
    options.yolo.model = std::filesystem::absolute(arguments.model).string();
  }
  if (!arguments.classes.empty()) {
    const bool isThere = std::filesystem::exists(arguments.classes);
    options.classes = (isThere ? std::filesystem::absolute(arguments.classes) : arguments.classes).string();
  }
  if (arguments.noNetwork) options.type = Segmenter::None;
}

/// Nobody said anything: neither a configuration nor the command line.
bool isLeftOpen(const FilterArguments& arguments) {
  return arguments.config.empty() && arguments.masks.empty() && arguments.model.empty() && !arguments.noNetwork;
}

}  // namespace

void addFilterArguments(CLI::App& command, FilterArguments& arguments) {
  command.add_option("--config", arguments.config, "configuration (YAML); `wardslam config` prints the defaults");
  auto* masks = command.add_option("--masks", arguments.masks,
                                   "folder of recorded masks, one PNG of class ids per colour image, named by stamp");
  auto* model = command.add_option("--model", arguments.model, "YOLO segmentation network (ONNX)")->excludes(masks);
  command.add_option("--classes", arguments.classes,
                     "what the numbers of classes mean, in masks or from a network: a label file (YAML, "
                     "'classes: [person, chair]' or 'classes: {255: person}')");
  command
      .add_flag("--no-network", arguments.noNetwork,
                "tell what moves by geometry alone; else, without masks or a model, the network that comes with the "
                "program finds people and furniture in the depth image; who sits still is then in the map, as a thing "
                "would be")
      ->excludes(masks)
      ->excludes(model);
  command
      .add_option("--mode", arguments.mode,
                  "tracking waits for the masks of each frame, or takes the newest, carried to the frame")
      ->check(CLI::IsMember({"wait", "propagate"}));
}

pipeline::SlamOptions effectiveOptions(const FilterArguments& arguments, const std::string& program) {
  auto options = arguments.config.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(arguments.config);
  chooseSegmenter(arguments, options.segmentation);
  options.deterministic = options.deterministic || arguments.deterministic;
  const bool hasMasks = options.segmentation.type != Segmenter::None;
  if (arguments.filter == "on" && !hasMasks) {
    throw UsageError(
        "--filter on needs masks: give --masks DIR, --model FILE.onnx or a configuration with a segmenter, or leave "
        "--no-network away");
  }
  if (arguments.filter == "off") {
    options.segmentation.type = Segmenter::None;
    options.filters = pipeline::SlamOptions::noFilters();
  } else if (arguments.filter == "geometric") {
    options.segmentation.type = Segmenter::None;
    options.keepOnlyFilters(kGeometricFilter);
  } else if (arguments.noNetwork) {
    options.removeFilters(kSemanticFilter);
  } else if (isLeftOpen(arguments)) {
    std::cerr << program << ": without --masks or --model the network that comes with the program finds people and "
              << "furniture in the depth image (--no-network: geometry alone)\n";
  }
  if (!arguments.mode.empty() && !options.setFilterParameter(kSemanticFilter, "mode", arguments.mode)) {
    throw UsageError("--mode says how the SemanticDynamicFilter gets its masks, but that filter is not in use");
  }
  for (const std::string& sentence : segmentation::assumptionsOf(options.segmentation)) {
    std::cerr << program << ": " << sentence << "\n";
  }
  return options;
}

void requireSomebodyLooksForPeople(const pipeline::SlamOptions& options, bool keepsPeople,
                                   const std::string& whatShows) {
  if (keepsPeople || options.segments()) return;
  throw UsageError(whatShows +
                   " no people by default, and without masks or a network nobody knows where they are; "
                   "give --masks DIR or --model FILE.onnx, leave --no-network away, or give --keep-people");
}

}  // namespace wardslam::apps
