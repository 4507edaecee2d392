#include <mrpt/obs/CObservation3DRangeScan.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "recording/rawlog_writer.h"
#include "recording/tum_notes.h"
#include "support/command_line.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "wardslam/core/errors.h"
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

/// Observations copied. Throws when interrupted.
std::size_t copyAll(sources::ObservationSource& source, recording::RawlogWriter& rawlog) {
  const InterruptionGuard interruption;
  Progress progress(std::cerr, standardErrorIsTerminal(), "frame", source.size());
  std::size_t copied = 0;
  while (const auto observation = source.next()) {
    if (interruption.requested()) throw core::InputError("interrupted; no rawlog was written");
    rawlog.write(*observation);
    progress.update(++copied);
  }
  return copied;
}

int convert(const Arguments& arguments) {
  sources::SourceOptions options;
  if (!arguments.camera.empty()) options.camera = arguments.camera;
  options.depth_units_per_m = arguments.depthFactor;
  options.warn = warn;
  options.note = warn;
  const auto source = sources::openSource(arguments.input, options);
  recording::RawlogWriter rawlog(arguments.output);
  if (std::filesystem::is_directory(arguments.input)) {
    recording::writeTumNotes(recording::notesOfTumFolder(arguments.input), rawlog);
  }
  const std::size_t copied = copyAll(*source, rawlog);
  if (copied == 0) throw core::InputError(arguments.input.string() + ": no image pair could be read");
  rawlog.commit();

  std::cout << arguments.output.string() << ": " << copied << " observations\n";
  if (source->damage().empty()) return kSuccess;
  warn("parts of the input could not be read; the rawlog holds the rest");
  return kFailure;
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
