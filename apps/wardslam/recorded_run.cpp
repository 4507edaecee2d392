#include "recorded_run.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <sstream>

#include "dynamic_truth.h"
#include "picture_writer.h"
#include "run_folder.h"
#include "support/playback_clock.h"
#include "support/progress.h"
#include "support/told_at_once.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/first_failure.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/pipeline/run_statistics.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/pipeline/zone_watch.h"
#include "wardslam/sources/observation_source.h"
#include "wardslam/storage/map_file_writer.h"
#include "wardslam/viewer/live_window.h"

namespace wardslam::apps {
namespace {

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

sources::SourceOptions sourceOptions(const RecordedRun& run, InputTrouble& trouble) {
  sources::SourceOptions options;
  if (!run.camera.empty()) options.camera = run.camera;
  options.stereo = run.options.sources.stereo;
  options.warn = [&trouble](const std::string& sentence) { trouble.add(sentence); };
  return options;
}

std::optional<std::size_t> expectedFrames(const sources::ObservationSource& source, const RecordedRun& run) {
  const auto size = source.size();
  if (!run.maxFrames) return size;
  return size ? std::min(*size, *run.maxFrames) : *run.maxFrames;
}

/// Feeds the source to the system until it ends, enough frames were done, or the user interrupts.
void processAll(sources::ObservationSource& source, pipeline::SlamSystem& slam, pipeline::RunStatistics& statistics,
                InputTrouble& trouble, const RecordedRun& run, const InterruptionGuard& interruption) {
  Progress progress(std::cerr, standardErrorIsTerminal(), run.progressUnit, expectedFrames(source, run));
  PlaybackClock clock;
  while (!interruption.requested() && statistics.frames() < run.maxFrames.value_or(SIZE_MAX)) {
    const auto observation = source.next();
    if (!observation) break;
    if (run.realtime) clock.waitFor(core::fromMrptTime(observation->timestamp));
    try {
      slam.process(observation);
    } catch (const core::FrameError& error) {
      trouble.add(run.input.string() + ": " + error.what());
      statistics.addUnusable();
    }
    progress.update(statistics.frames());
  }
}

/// What libraries say has lines and blanks of its own.
std::string inOneLine(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

/// Does `work`; what is no error of the input, a library's or memory that is used up, becomes one sentence.
void attemptRun(const RecordedRun& run, const pipeline::RunStatistics& statistics, const std::function<void()>& work) {
  try {
    work();
  } catch (const core::InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw core::InputError(run.input.string() + ": the run ended after " + std::to_string(statistics.frames()) +
                           " images, of which trajectory, map and summary are written: " + inOneLine(error.what()));
  }
}

/// What a robot's map lacks because mapping came too late.
void tellWhatWasLeftOut(const core::EventCounts& leftOut) {
  std::string text;
  const auto add = [&](const char* event, const char* why) {
    const auto found = leftOut.find(event);
    if (found == leftOut.end()) return;
    text += (text.empty() ? "" : ", ") + std::to_string(found->second) + why;
  };
  add("mapping.view_left_out", " images that are no keyframes came faster than they could be worked in");
  add("mapping.view_without_masks", " had no masks in time");
  if (!text.empty()) tellAtOnce("not everything is in the map: " + text);
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

storage::MapFileWriter openMapFile(const RecordedRun& run, const pipeline::SlamSystem& slam) {
  if (!run.map.empty()) return storage::MapFileWriter(storage::MapFile::open(run.map, storage::MapAccess::Write));
  return {run.out / "map.wardmap", storage::MapHeader{slam.labelSpace(), slam.configuration()}};
}

pipeline::EarlierMap earlierMapOf(const RecordedRun& run) {
  if (run.map.empty()) return {};
  return pipeline::readEarlierMap(run.map, run.localize ? graph::Saved::IsHeld : graph::Saved::MayChange);
}

/// Without a place in common, the poses of the run say nothing about the map.
void requireRecognition(const RecordedRun& run, const pipeline::SlamSystem& slam) {
  if (run.map.empty() || slam.recognisedAt_s()) return;
  throw core::InputError(run.map.string() + ": no place of this map was recognised in " + run.input.string() +
                         "; the trajectory is in a frame of its own and the map is as it was");
}

}  // namespace

namespace {

/// Images that came too late for a robot; a recording waits until they are worked in.
pipeline::WhenBehind whenBehind(const RecordedRun& run, bool isLive) {
  return isLive || run.realtime ? pipeline::WhenBehind::LeavesViewsOut : pipeline::WhenBehind::Waits;
}

}  // namespace

bool perform(const RecordedRun& run, const InterruptionGuard& interruption) {
  InputTrouble trouble;
  std::optional<LiveRun> live;
  std::unique_ptr<sources::ObservationSource> recording;
  if (sources::isSensorConfiguration(run.input)) {
    live.emplace(run.input, run.live, run.options.sources.live, sourceOptions(run, trouble), interruption);
  } else {
    recording = sources::openSource(run.input, sourceOptions(run, trouble));
  }
  sources::ObservationSource& source = live ? live->source() : *recording;
  std::optional<storage::MapFileWriter> mapFile;  // outlives the system that writes to it
  pipeline::SlamSystem slam(run.options, earlierMapOf(run), whenBehind(run, live.has_value()));
  slam.setDepthNoise(source.depthNoise());
  std::optional<DynamicTruth> truth;
  if (!run.dynamicTruth.empty()) truth.emplace(run.dynamicTruth);
  RunFolder folder(run.out);
  folder.writeConfiguration(slam.configuration());

  pipeline::RunStatistics statistics;
  PictureWriter pictures(run.out / "pictures", run.pictureInterval, slam.labelSpace());
  pipeline::ZoneWatch zoneWatch(slam.zones());
  slam.addObserver(statistics);
  slam.addObserver(zoneWatch);
  slam.addObserver(folder);
  if (live) slam.addObserver(*live);
  slam.addObserver(pictures);
  std::optional<viewer::LiveWindow> window;
  if (run.view) slam.addObserver(window.emplace(slam.labelSpace()));
  if (truth) slam.addObserver(*truth);

  if (slam.buildsSemanticMap()) {
    mapFile.emplace(openMapFile(run, slam));
    mapFile->setWarningSink(tellAtOnce);
    slam.writeTo(*mapFile);
  }
  // Whatever goes wrong from here on, what went well until then is written first.
  core::FirstFailure failure;
  failure.attempt(
      [&] { attemptRun(run, statistics, [&] { processAll(source, slam, statistics, trouble, run, interruption); }); });
  if (live) live->source().close();
  failure.attempt([&] { attemptRun(run, statistics, [&] { slam.finish(); }); });
  failure.attempt([&] {
    if (mapFile) attemptRun(run, statistics, [&] { mapFile->finish(*slam.mapBuilder(), slam.mapper()); });
  });
  const bool isInterrupted = interruption.requested();
  failure.attempt([&] {
    folder.finish({statistics, zoneWatch, source.damage(), slam, mapFile ? mapFile->failedWrites() : 0,
                   truth ? &*truth : nullptr, live ? &*live : nullptr, isInterrupted, run.options.deterministic});
  });
  if (live) std::cerr << "wardslam: " << live->closingLine(statistics.frames()) << "\n";
  tellWhatWasLeftOut(slam.leftOut());
  failure.rethrow();
  if (!isInterrupted) slam.requireSoundSetup();
  requireSoundInput(source, statistics, trouble, run.input);
  if (!isInterrupted) requireRecognition(run, slam);
  if (truth && statistics.frames() > 0 && truth->frames() == 0) {
    throw core::InputError(run.dynamicTruth.string() +
                           ": no image belongs to any frame; they must be named by the stamps of the colour images");
  }
  return !isInterrupted;
}

}  // namespace wardslam::apps
