#include <mrpt/obs/CObservation3DRangeScan.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "support/command_line.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "tum_folder_writer.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::rawlog2tum {
namespace {

struct Arguments {
  std::filesystem::path input;
  std::filesystem::path output;
  std::filesystem::path camera;
  std::string sensor;
};

void warn(const std::string& sentence) { std::cerr << "rawlog2tum: " << sentence << "\n"; }

/// Images written. Throws when interrupted.
std::size_t writeAll(sources::ObservationSource& source, TumFolderWriter& folder) {
  const apps::InterruptionGuard interruption;
  apps::Progress progress(std::cerr, apps::standardErrorIsTerminal(), "frame", source.size());
  sources::FrameBuilder frameBuilder;
  std::size_t written = 0;
  while (const auto scan = source.next()) {
    if (interruption.requested()) throw core::InputError("interrupted; nothing was written");
    folder.write(frameBuilder.build(scan), static_cast<double>(scan->rangeUnits));
    progress.update(++written);
  }
  return written;
}

int convert(const Arguments& arguments) {
  if (!std::filesystem::is_regular_file(arguments.input)) {
    throw core::InputError(arguments.input.string() + ": no such file");
  }
  TumFolderWriter folder(arguments.output, recording::readTumNotes(arguments.input));
  sources::SourceOptions options;
  if (!arguments.camera.empty()) options.camera = arguments.camera;
  options.sensor = arguments.sensor;
  options.warn = warn;
  options.note = warn;
  const auto source = sources::openSource(arguments.input, options);
  const std::size_t written = writeAll(*source, folder);
  folder.commit();
  if (const auto sentence = source->sensors().sentence()) warn(arguments.input.string() + ": " + *sentence);

  std::cout << arguments.output.string() << ": " << written << " image pairs\n";
  if (source->damage().empty()) return apps::kSuccess;
  warn("parts of the input could not be read; the folder holds the rest");
  return apps::kFailure;
}

}  // namespace
}  // namespace wardslam::rawlog2tum

int main(int argc, char** argv) {
  using namespace wardslam::rawlog2tum;
  return wardslam::apps::runProgram("rawlog2tum", [&]() -> int {
    CLI::App app("Turns the RGB-D scans of an MRPT rawlog into a folder in the layout of the TUM RGB-D benchmark",
                 "rawlog2tum");
    app.set_version_flag("--version", "rawlog2tum " WARDSLAM_VERSION);
    Arguments arguments;
    app.add_option("INPUT", arguments.input, "rawlog to read")->required();
    app.add_option("-o,--output", arguments.output, "folder to write; must not be there yet")->required();
    app.add_option("--sensor", arguments.sensor, "label of the RGB-D sensor; the first in the rawlog unless given");
    app.add_option("--camera", arguments.camera, "calibration (YAML); replaces that of the scans");
    if (const auto code = wardslam::apps::parseCommandLine(app, argc, argv)) return *code;
    return convert(arguments);
  });
}
