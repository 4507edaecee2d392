#include "run_command.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "picture_writer.h"
#include "run_folder.h"
#include "support/interruption.h"
#include "support/playback_clock.h"
#include "support/program.h"
#include "support/progress.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/pipeline/run_statistics.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/pipeline/zone_watch.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::apps {
namespace {

struct RunArguments {
  std::filesystem::path input;
  std::filesystem::path out;
  std::filesystem::path config;
  std::filesystem::path camera;
  std::filesystem::path masks;
  std::filesystem::path model;
  std::filesystem::path zones;
  std::string filter;
  std::string mode;
  std::string startPose;
  std::optional<std::size_t> maxFrames;
  bool deterministic = false;
  bool realtime = false;
  std::size_t pictureInterval = 0;
};

void warn(const std::string& sentence) { std::cerr << "wardslam: " << sentence << "\n"; }

/// The configuration file, overruled by the command line.
pipeline::SlamOptions effectiveOptions(const RunArguments& arguments) {
  using Segmenter = segmentation::SegmentationOptions::Type;
  auto options = arguments.config.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(arguments.config);
  if (!arguments.masks.empty()) {
    options.segmentation.type = Segmenter::RecordedMasks;
    options.segmentation.recorded_masks.folder = std::filesystem::absolute(arguments.masks).string();
  }
  if (!arguments.model.empty()) {
    options.segmentation.type = Segmenter::Yolo;
    options.segmentation.yolo.model = std::filesystem::absolute(arguments.model).string();
  }
  if (!arguments.zones.empty()) options.zones.file = std::filesystem::absolute(arguments.zones).string();
  if (!arguments.startPose.empty()) options.map_frame.start_pose = arguments.startPose;
  options.deterministic = options.deterministic || arguments.deterministic;
  const bool hasMasks = options.segmentation.type != Segmenter::None;
  if (arguments.filter == "on" && !hasMasks) {
    throw UsageError(
        "--filter on needs masks: give --masks DIR, --model FILE.onnx or a configuration with a segmenter");
  }
  if (arguments.filter == "off") {
    options.segmentation.type = Segmenter::None;
    options.filters = pipeline::SlamOptions::noFilters();
  } else if (!hasMasks && arguments.config.empty()) {
    warn("without --masks or --model nothing is segmented: running with the filter off");
    options.filters = pipeline::SlamOptions::noFilters();
  }
  if (!arguments.mode.empty() &&
      !options.setFilterParameter("wardslam::filters::SemanticDynamicFilter", "mode", arguments.mode)) {
    throw UsageError("--mode says how the SemanticDynamicFilter gets its masks, but that filter is not in use");
  }
  return options;
}

/// The first sentence about input that cannot be used. It is told when the run is over, not between two redraws of
/// the progress line.
class InputTrouble {
 public:
  void add(const std::string& sentence) {
    if (first_.empty()) first_ = sentence;
  }
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  std::string first_;
};

sources::SourceOptions sourceOptions(const RunArguments& arguments, InputTrouble& trouble) {
  sources::SourceOptions options;
  if (!arguments.camera.empty()) options.camera = arguments.camera;
  options.warn = [&trouble](const std::string& sentence) { trouble.add(sentence); };
  return options;
}

std::optional<std::size_t> expectedFrames(const sources::ObservationSource& source, const RunArguments& arguments) {
  const auto size = source.size();
  if (!arguments.maxFrames) return size;
  return size ? std::min(*size, *arguments.maxFrames) : *arguments.maxFrames;
}

/// Feeds the source to the system until it ends, enough frames were done, or the user interrupts.
void processAll(sources::ObservationSource& source, pipeline::SlamSystem& slam, pipeline::RunStatistics& statistics,
                InputTrouble& trouble, const RunArguments& arguments, const InterruptionGuard& interruption) {
  Progress progress(std::cerr, standardErrorIsTerminal(), "frame", expectedFrames(source, arguments));
  PlaybackClock clock;
  while (!interruption.requested() && statistics.frames() < arguments.maxFrames.value_or(SIZE_MAX)) {
    const auto observation = source.next();
    if (!observation) break;
    if (arguments.realtime) clock.waitFor(core::fromMrptTime(observation->timestamp));
    try {
      slam.process(observation);
    } catch (const core::FrameError& error) {
      trouble.add(arguments.input.string() + ": " + error.what());
      statistics.addUnusable();
    }
    progress.update(statistics.frames());
  }
}

/// The run is written in full by now; what was wrong with its input still makes it a failure.
void requireSoundInput(const sources::ObservationSource& source, const pipeline::RunStatistics& statistics,
                       const InputTrouble& trouble, const std::filesystem::path& input) {
  std::size_t unusable = statistics.unusableFrames();
  for (const auto& [kind, count] : source.damage()) unusable += count;
  if (unusable > 1) {
    throw core::InputError(trouble.first() + " (the first of " + std::to_string(unusable) +
                           " parts of the input that could not be used; summary.json counts them by kind)");
  }
  if (unusable == 1) throw core::InputError(trouble.first());
  if (statistics.frames() > 0 && statistics.framesTracked() == 0) {
    throw core::InputError(input.string() +
                           ": no frame could be tracked; does every image have texture and depth, and is the camera "
                           "file the right one?");
  }
}

void run(const RunArguments& arguments) {
  const auto options = effectiveOptions(arguments);
  InputTrouble trouble;
  const auto source = sources::openSource(arguments.input, sourceOptions(arguments, trouble));
  pipeline::SlamSystem slam(options);
  RunFolder folder(arguments.out);
  folder.writeConfiguration(slam.configuration());

  pipeline::RunStatistics statistics;
  PictureWriter pictures(arguments.out / "pictures", arguments.pictureInterval, slam.labelSpace());
  pipeline::ZoneWatch zoneWatch(slam.zones());
  slam.addObserver(statistics);
  slam.addObserver(zoneWatch);
  slam.addObserver(folder);
  slam.addObserver(pictures);

  const InterruptionGuard interruption;
  std::exception_ptr failure;
  try {
    processAll(*source, slam, statistics, trouble, arguments, interruption);
  } catch (const core::InputError&) {
    failure = std::current_exception();  // what went well until then is written first
  }
  slam.finish();
  folder.finish({statistics, zoneWatch, source->damage(), slam, interruption.requested(), options.deterministic});
  if (failure) std::rethrow_exception(failure);
  if (!interruption.requested()) slam.requireSoundSetup();
  requireSoundInput(*source, statistics, trouble, arguments.input);
}

}  // namespace

void addRunCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("run", "Track the camera through a recording and write what was found to DIR");
  auto arguments = std::make_shared<RunArguments>();
  command->add_option("INPUT", arguments->input, "a .rawlog file or a folder in the layout of the TUM RGB-D benchmark")
      ->required();
  command->add_option("--out", arguments->out, "folder for the results; made when absent")->required();
  command->add_option("--config", arguments->config, "configuration (YAML); `wardslam config` prints the defaults");
  command->add_option("--camera", arguments->camera, "calibration (YAML); replaces the one of the recording");
  command->add_option("--filter", arguments->filter, "whether to leave out what moves; on where there are masks")
      ->check(CLI::IsMember({"on", "off"}));
  auto* masks = command->add_option("--masks", arguments->masks,
                                    "folder of recorded masks, one PNG of class ids per colour image, named by stamp");
  command->add_option("--model", arguments->model, "YOLO segmentation network (v5 or v8 layout, ONNX)")
      ->excludes(masks);
  command
      ->add_option("--mode", arguments->mode,
                   "tracking waits for the masks of each frame, or takes the newest, carried to the frame")
      ->check(CLI::IsMember({"wait", "propagate"}));
  command->add_option("--zones", arguments->zones, "named parts of the floor (YAML), in the map frame");
  command->add_option("--start-pose", arguments->startPose,
                      "where the first image was taken in the map frame, \"x y z qx qy qz qw\" (optical camera frame)");
  command->add_option("--max-frames", arguments->maxFrames, "stop after so many frames")->check(CLI::PositiveNumber);
  command->add_flag("--realtime", arguments->realtime, "frames come no faster than they were recorded");
  command->add_flag("--deterministic", arguments->deterministic, "same input, same bytes out");
  command
      ->add_option("--pictures", arguments->pictureInterval,
                   "write every N-th frame (10th without N) with masks, boxes and key points to DIR/pictures")
      ->expected(0, 1)
      ->default_str("10")
      ->check(CLI::PositiveNumber);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace wardslam::apps
