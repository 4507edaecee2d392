#include <CLI/CLI.hpp>

#include "arguments.h"

namespace wardslam::synth {

void declareOutput(CLI::App& app, OutputOptions& options) {
  app.option_defaults()->group("Output");
  app.add_option("-o,--output", options.file,
                 "FILE.rawlog to write; FILE.groundtruth.txt and FILE_labels/ go beside it")
      ->required()
      ->check([](const std::string& file) {
        return std::filesystem::path(file).extension() == ".rawlog" ? std::string() : "must end in .rawlog";
      });
  app.add_option("--seconds", options.seconds, "how long it lasts; unless told 20 s of the ward, a round of the floor")
      ->check(CLI::Range(0.01, 3600.0));
}

}  // namespace wardslam::synth
