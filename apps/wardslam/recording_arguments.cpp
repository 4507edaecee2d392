#include "recording_arguments.h"

#include <CLI/CLI.hpp>

namespace wardslam::apps {

void addRecordingArguments(CLI::App& command, RecordingArguments& arguments) {
  command
      .add_option(
          "INPUT", arguments.input,
          "a .rawlog file, a folder in the layout of the TUM RGB-D benchmark, a recording of ROS (.bag, .mcap, .db3 or "
          "the folder of a ROS 2 bag), or an .ini file of rawlog-grabber (a live camera)")
      ->required();
  command.add_option("--out", arguments.out, "folder for the results; made when absent")->required();
  command.add_option(
      "--camera", arguments.camera,
      "calibration (YAML, ours or one of the programs in docs/inputs.md); replaces the one of the recording");
  command
      .add_option(
          "--depth-factor", arguments.depthFactor,
          "value of a depth pixel one metre away (1000 for millimetres, 5000 for the TUM benchmark's); replaces "
          "what camera file or rawlog say")
      ->check(CLI::Range(1.0, 1e6));
  command.add_option("--color", arguments.topics.color, "topic of the colour images, in a recording of ROS");
  command.add_option("--depth", arguments.topics.depth, "topic of the depth images, in a recording of ROS");
  command.add_option("--info", arguments.topics.info, "topic of the calibration, in a recording of ROS");
  addFilterArguments(command, arguments);
  command.add_option("--zones", arguments.zones, "named parts of the floor (YAML), in the map frame");
  command.add_option("--start-pose", arguments.startPose,
                     "where the first image was taken in the map frame, \"x y z qx qy qz qw\" (optical camera frame)");
  command.add_option("--max-frames", arguments.maxFrames, "stop after so many frames")->check(CLI::PositiveNumber);
  command.add_option("--dynamic-truth", arguments.dynamicTruth,
                     "folder of PNGs named by stamp, not 0 where the picture truly moves; what the filters mark is "
                     "compared with them");
}

pipeline::SlamOptions effectiveOptions(const RecordingArguments& arguments) {
  auto options = effectiveOptions(arguments, "wardslam");
  if (!arguments.zones.empty()) options.zones.file = std::filesystem::absolute(arguments.zones).string();
  if (!arguments.startPose.empty()) options.map_frame.start_pose = arguments.startPose;
  return options;
}

}  // namespace wardslam::apps
