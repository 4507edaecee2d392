#include <CLI/CLI.hpp>

#include "config_command.h"
#include "doctor_command.h"
#include "eval_command.h"
#include "eval_floor_command.h"
#include "eval_objects_command.h"
#include "eval_rooms_command.h"
#include "fleet_command.h"
#include "knowledge_command.h"
#include "map_command.h"
#include "models_command.h"
#include "report_command.h"
#include "reproduce_command.h"
#include "run_command.h"
#include "support/command_line.h"
#include "support/program.h"
#include "sweep_command.h"

int main(int argc, char** argv) {
  using namespace wardslam::apps;
  return runProgram("wardslam", [&]() -> int {
    CLI::App app("RGB-D SLAM that leaves out what moves", "wardslam");
    app.set_version_flag("--version", "wardslam " WARDSLAM_VERSION);
    app.require_subcommand(1);
    addRunCommand(app);
    addReportCommand(app);
    addSweepCommand(app);
    addReproduceCommand(app);
    addEvalCommand(app);
    addEvalObjectsCommand(app);
    addEvalFloorCommand(app);
    addEvalRoomsCommand(app);
    addConfigCommand(app);
    addModelsCommand(app);
    addKnowledgeCommand(app);
    addMapCommand(app);
    addFleetCommand(app);
    addDoctorCommand(app);
    return parseCommandLine(app, argc, argv).value_or(kSuccess);
  });
}
