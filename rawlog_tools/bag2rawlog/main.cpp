#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "recording/rawlog_conversion.h"
#include "support/command_line.h"
#include "support/program.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/bag_observations.h"
#include "wardslam/sources/choice_needed.h"

namespace wardslam::apps {
namespace {

struct Arguments {
  std::filesystem::path input;
  std::filesystem::path output;
  std::filesystem::path camera;
  sources::BagTopics topics;
};

void warn(const std::string& sentence) { std::cerr << "bag2rawlog: " << sentence << "\n"; }

int convert(const Arguments& arguments) {
  if (!std::filesystem::exists(arguments.input)) {
    throw core::InputError(arguments.input.string() + ": no such file or folder");
  }
  sources::SourceOptions options;
  if (!arguments.camera.empty()) options.camera = arguments.camera;
  options.warn = options.note = warn;
  options.topics = arguments.topics;
  sources::BagObservations bag(arguments.input, options);
  recording::RawlogConversion conversion;
  conversion.program = "bag2rawlog";
  conversion.input = arguments.input;
  conversion.output = arguments.output;
  conversion.size = bag.size();
  conversion.next = [&] { return bag.next(); };
  conversion.isDamaged = [&] { return !bag.damage().empty(); };
  conversion.mayHoldOthers = true;
  return recording::convertToRawlog(conversion);
}

int convertOrAsk(const Arguments& arguments) {
  try {
    return convert(arguments);
  } catch (const sources::ChoiceNeeded& choice) {
    throw UsageError(choice.what());
  }
}

}  // namespace
}  // namespace wardslam::apps

int main(int argc, char** argv) {
  using namespace wardslam::apps;
  return runProgram("bag2rawlog", [&]() -> int {
    CLI::App app("Turns a recording of ROS 1 or ROS 2 into an MRPT rawlog, without ROS", "bag2rawlog");
    app.set_version_flag("--version", "bag2rawlog " WARDSLAM_VERSION);
    Arguments arguments;
    app.add_option("BAG", arguments.input, "a .bag of ROS 1, an .mcap or .db3 file, or the folder of a ROS 2 bag")
        ->required();
    app.add_option("-o,--output", arguments.output, "rawlog to write; images are embedded without loss")->required();
    app.add_option("--color", arguments.topics.color, "topic of the colour images; found by type and name without");
    app.add_option("--depth", arguments.topics.depth, "topic of the depth images");
    app.add_option("--info", arguments.topics.info,
                   "topic of the colour camera's calibration (sensor_msgs/CameraInfo)");
    app.add_option("--odometry", arguments.topics.odometry, "topic of the odometry, where there are several");
    app.add_option("--camera", arguments.camera, "calibration of the colour camera (YAML); replaces the recorded one");
    if (const auto code = parseCommandLine(app, argc, argv)) return *code;
    return convertOrAsk(arguments);
  });
}
