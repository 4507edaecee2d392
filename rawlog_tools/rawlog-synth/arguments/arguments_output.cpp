#include <CLI/CLI.hpp>

#include "arguments/arguments.h"
#include "arguments/within.h"

namespace wardslam::synth {

void declareOutput(CLI::App& app, OutputOptions& options) {
  app.option_defaults()->group("Output");
  app.add_option(
         "-o,--output", options.file,
         "FILE.rawlog to write, or a folder for the layout of the TUM RGB-D benchmark; FILE.groundtruth.txt (in "
         "a folder groundtruth.txt) and FILE_labels/ go with it")
      ->required();
  app.add_flag("--tum", options.isTumFolder, "a folder, whatever its name ends in");
  app.add_option("--seconds", options.seconds,
                 "how long it lasts; unless told 20 s of the ward, a round of the floor (60 s), all of the hospital's "
                 "route (12 minutes and more of the tour)")
      ->check(within(0.01, 3600.0));
}

std::string settleOutput(SynthesisOptions& options) {
  OutputOptions& output = options.output;
  const std::string ending = output.file.extension().string();
  if (output.isTumFolder || ending.empty()) {
    output.isTumFolder = true;
    if (options.camera.stereoBaseline_m) return "--stereo: the TUM layout has no stereo pairs; write a FILE.rawlog";
    return {};
  }
  return ending == ".rawlog" ? "" : "--output: must end in .rawlog, or be a folder (--tum)";
}

}  // namespace wardslam::synth
