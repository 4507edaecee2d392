#include "run_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "recorded_run.h"
#include "recording_arguments.h"
#include "support/interruption.h"
#include "support/program.h"
#include "wardslam/sources/sensor_configuration.h"

namespace wardslam::apps {
namespace {

struct RunArguments {
  RecordingArguments recording;
  LiveInput live;
  std::filesystem::path map;
  bool localize = false;
  bool realtime = false;
  bool view = false;
  std::size_t pictureInterval = 0;
  bool keepPeople = false;
  bool report = false;
  bool isPrivate = false;
};

void requireFittingArguments(const RunArguments& arguments) {
  const bool isLive = sources::isSensorConfiguration(arguments.recording.input);
  if (!isLive && (!arguments.live.plugins.empty() || arguments.live.seconds)) {
    throw UsageError("--sensor-plugin and --seconds are for cameras: INPUT must be an .ini file");
  }
  if (!arguments.live.section.empty() && std::filesystem::is_directory(arguments.recording.input)) {
    throw UsageError("--sensor is for .ini files and rawlogs: a folder of images has one sensor");
  }
  if (isLive &&
      (arguments.realtime || !arguments.recording.masks.empty() || !arguments.recording.dynamicTruth.empty())) {
    throw UsageError("--realtime, --masks and --dynamic-truth are for recordings, not for a camera");
  }
  if (arguments.isPrivate && !arguments.map.empty() && !arguments.localize) {
    throw UsageError("--private begins a new map: the one of --map has stamps of its own, which would not fit");
  }
}

/// What is promised of people can only be kept where something finds them.
void requirePrivacy(const RunArguments& arguments, const pipeline::SlamOptions& options) {
  if (arguments.isPrivate && !options.segments()) {
    throw UsageError("--private needs masks or a network: without, who sits still is in the map as a thing would be");
  }
  if (arguments.pictureInterval > 0) requireSomebodyLooksForPeople(options, arguments.keepPeople, "pictures show");
}

void run(const RunArguments& arguments) {
  requireFittingArguments(arguments);
  const RecordingArguments& recording = arguments.recording;
  RecordedRun run;
  run.input = recording.input;
  run.live = arguments.live;
  run.camera = recording.camera;
  run.depthFactor = recording.depthFactor;
  run.topics = recording.topics;
  run.out = recording.out;
  run.options = effectiveOptions(recording);
  requirePrivacy(arguments, run.options);
  run.map = arguments.map;
  run.localize = arguments.localize;
  if (run.localize) run.options.mapping.enabled = false;
  run.maxFrames = recording.maxFrames;
  run.dynamicTruth = recording.dynamicTruth;
  run.realtime = arguments.realtime;
  run.view = arguments.view;
  run.pictureInterval = arguments.pictureInterval;
  run.keepPeople = arguments.keepPeople;
  run.report = arguments.report;
  run.isPrivate = arguments.isPrivate;
  perform(run, InterruptionGuard());
}

}  // namespace

void addRunCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("run", "Track a camera, live or through a recording, and write what was found to DIR");
  auto arguments = std::make_shared<RunArguments>();
  addRecordingArguments(*command, arguments->recording);
  command
      ->add_option("--filter", arguments->recording.filter,
                   "how to leave out what moves: by masks and geometry (on), by geometry alone, not at all; on where "
                   "there are masks, else geometric")
      ->check(CLI::IsMember({"on", "geometric", "off"}));
  auto* map = command
                  ->add_option("--map", arguments->map,
                               "go on in this map (.wardmap), which grows; the camera may start anywhere in it")
                  ->check(CLI::ExistingFile);
  command->add_flag("--localize", arguments->localize, "only find the camera's place in the map, without changing it")
      ->needs(map);
  command->add_option("--sensor", arguments->live.section,
                      "where INPUT has several sensors: section of the .ini file, or label in the rawlog");
  command->add_option("--sensor-plugin", arguments->live.plugins, "library with further MRPT sensor classes")
      ->check(CLI::ExistingFile);
  command->add_option("--seconds", arguments->live.seconds, "stop a camera after so long (else with Ctrl-C)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--realtime", arguments->realtime, "frames come no faster than they were recorded");
  command->add_flag("--view", arguments->view, "show the run in a window");
  command->add_flag("--deterministic", arguments->recording.deterministic, "same input, same bytes out");
  command
      ->add_option("--pictures", arguments->pictureInterval,
                   "write every N-th frame (10th without N) with masks, boxes and key points to DIR/pictures")
      ->expected(0, 1)
      ->default_str("10")
      ->check(CLI::PositiveNumber);
  command->add_flag("--keep-people", arguments->keepPeople, "leave people in the pictures; else they are blanked");
  command->add_flag(
      "--report", arguments->report,
      "at the end write DIR/report.html: all of it on one page for a browser; the truth of a TUM folder beside it");
  command->add_flag(
      "--private", arguments->isPrivate,
      "stamps in all files are seconds since the first image, and no file names a folder of this computer");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace wardslam::apps
