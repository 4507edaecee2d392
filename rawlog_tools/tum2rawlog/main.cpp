#include <mrpt/obs/CObservation3DRangeScan.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "recording/rawlog_conversion.h"
#include "recording/tum_notes.h"
#include "support/command_line.h"
#include "support/program.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::apps {
namespace {

struct Arguments {
  std::filesystem::path input;
  std::filesystem::path output;
  std::filesystem::path camera;
  std::optional<double> depthFactor;
};

void warn(const std::string& sentence) { std::cerr << "tum2rawlog: " << sentence << "\n"; }

int convert(const Arguments& arguments) {
  sources::SourceOptions options;
  if (!arguments.camera.empty()) options.camera = arguments.camera;
  options.depth_units_per_m = arguments.depthFactor;
  options.warn = warn;
  options.note = warn;
  const auto source = sources::openSource(arguments.input, options);
  recording::RawlogConversion conversion;
  conversion.program = "tum2rawlog";
  conversion.input = arguments.input;
  conversion.output = arguments.output;
  conversion.size = source->size();
  conversion.next = [&] { return source->next(); };
  conversion.isDamaged = [&] { return !source->damage().empty(); };
  if (std::filesystem::is_directory(arguments.input)) {
    conversion.begin = [&](recording::RawlogWriter& rawlog) {
      recording::writeTumNotes(recording::notesOfTumFolder(arguments.input), rawlog);
    };
  }
  return recording::convertToRawlog(conversion);
}

}  // namespace
}  // namespace wardslam::apps

int main(int argc, char** argv) {
  using namespace wardslam::apps;
  return runProgram("tum2rawlog", [&]() -> int {
    CLI::App app("Turns a sequence in the layout of the TUM RGB-D benchmark into an MRPT rawlog", "tum2rawlog");
    app.set_version_flag("--version", "tum2rawlog " WARDSLAM_VERSION);
    Arguments arguments;
    app.add_option("TUM_DIR", arguments.input, "folder with rgb.txt and depth.txt, or associations.txt")->required();
    app.add_option("-o,--output", arguments.output, "rawlog to write; images are embedded without loss")->required();
    app.add_option("--camera", arguments.camera, "calibration (YAML); replaces the folder's camera.yaml");
    app.add_option(
           "--depth-factor", arguments.depthFactor,
           "value of a depth pixel one metre away (1000 for millimetres, 5000 for the TUM benchmark's); replaces "
           "what the camera file says")
        ->check(CLI::Range(1.0, 1e6));
    if (const auto code = parseCommandLine(app, argc, argv)) return *code;
    return convert(arguments);
  });
}
