#include "recording_arguments.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "support/program.h"

namespace wardslam::apps {
namespace {

constexpr const char* kGeometricFilter = "wardslam::filters::GeometricMotionFilter";

void warn(const std::string& sentence) { std::cerr << "wardslam: " << sentence << "\n"; }

}  // namespace

void addRecordingArguments(CLI::App& command, RecordingArguments& arguments) {
  command.add_option("INPUT", arguments.input, "a .rawlog file or a folder in the layout of the TUM RGB-D benchmark")
      ->required();
  command.add_option("--out", arguments.out, "folder for the results; made when absent")->required();
  command.add_option("--config", arguments.config, "configuration (YAML); `wardslam config` prints the defaults");
  command.add_option("--camera", arguments.camera, "calibration (YAML); replaces the one of the recording");
  auto* masks = command.add_option("--masks", arguments.masks,
                                   "folder of recorded masks, one PNG of class ids per colour image, named by stamp");
  command.add_option("--model", arguments.model, "YOLO segmentation network (v5 or v8 layout, ONNX)")->excludes(masks);
  command
      .add_option("--mode", arguments.mode,
                  "tracking waits for the masks of each frame, or takes the newest, carried to the frame")
      ->check(CLI::IsMember({"wait", "propagate"}));
  command.add_option("--zones", arguments.zones, "named parts of the floor (YAML), in the map frame");
  command.add_option("--start-pose", arguments.startPose,
                     "where the first image was taken in the map frame, \"x y z qx qy qz qw\" (optical camera frame)");
  command.add_option("--max-frames", arguments.maxFrames, "stop after so many frames")->check(CLI::PositiveNumber);
  command.add_option("--dynamic-truth", arguments.dynamicTruth,
                     "folder of PNGs named by stamp, not 0 where the picture truly moves; what the filters mark is "
                     "compared with them");
}

pipeline::SlamOptions effectiveOptions(const RecordingArguments& arguments) {
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
  if (!arguments.zones.empty()) options.zones.file = std::filesystem::absolute(arguments.zones).string();
  if (!arguments.startPose.empty()) options.map_frame.start_pose = arguments.startPose;
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
    warn("without --masks or --model nothing is segmented: what moves is told by geometry alone");
    options.keepOnlyFilters(kGeometricFilter);
  }
  if (!arguments.mode.empty() &&
      !options.setFilterParameter("wardslam::filters::SemanticDynamicFilter", "mode", arguments.mode)) {
    throw UsageError("--mode says how the SemanticDynamicFilter gets its masks, but that filter is not in use");
  }
  return options;
}

}  // namespace wardslam::apps
