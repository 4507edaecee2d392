#include <CLI/CLI.hpp>

#include "config_command.h"
#include "eval_command.h"
#include "run_command.h"
#include "support/program.h"

int main(int argc, char** argv) {
  using namespace wardslam::apps;
  return runProgram("wardslam", [&]() -> int {
    CLI::App app("RGB-D SLAM that leaves out what moves", "wardslam");
    app.set_version_flag("--version", "wardslam " WARDSLAM_VERSION);
    app.require_subcommand(1);
    addRunCommand(app);
    addEvalCommand(app);
    addConfigCommand(app);
    try {
      app.parse(argc, argv);
      return kSuccess;
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() != 0) throw UsageError(std::string(error.what()) + " (see wardslam --help)");
      return app.exit(error);  // prints the help or the version that was asked for
    }
  });
}
