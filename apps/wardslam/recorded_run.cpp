#include "recorded_run.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <utility>

#include "dynamic_truth.h"
#include "picture_writer.h"
#include "report_command.h"
#include "run_folder.h"
#include "still_camera.h"
#include "support/playback_clock.h"
#include "support/program.h"
#include "support/progress.h"
#include "support/told_at_once.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/first_failure.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/pipeline/run_statistics.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/pipeline/zone_watch.h"
#include "wardslam/sources/choice_needed.h"
#include "wardslam/sources/observation_source.h"
#include "wardslam/storage/map_copy.h"
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
  options.note = tellAtOnce;
  options.depth_units_per_m = run.depthFactor;
  options.sensor = run.live.section;
  options.topics = run.topics;
  options.warn = [&trouble](const std::string& sentence) { trouble.add(sentence); };
  return options;
}

std::unique_ptr<sources::ObservationSource> openRecording(const RecordedRun& run, InputTrouble& trouble) {
  try {
    return sources::openSource(run.input, sourceOptions(run, trouble));
  } catch (const sources::ChoiceNeeded& choice) {
    throw UsageError(choice.what());
  }
}

std::optional<std::size_t> expectedFrames(const sources::ObservationSource& source, const RecordedRun& run) {
  const auto size = source.size();
  if (!run.maxFrames) return size;
  return size ? std::min(*size, *run.maxFrames) : *run.maxFrames;
}

/// Feeds the source to the system until it ends, enough frames were done, or the user interrupts. `begin` is told when
/// the first image was taken.
void processAll(sources::ObservationSource& source, pipeline::SlamSystem& slam, pipeline::RunStatistics& statistics,
                InputTrouble& trouble, const RecordedRun& run, const InterruptionGuard& interruption,
                std::function<void(double start_s)> begin) {
  Progress progress(std::cerr, standardErrorIsTerminal(), run.progressUnit, expectedFrames(source, run));
  PlaybackClock clock;
  while (!interruption.requested() && statistics.frames() < run.maxFrames.value_or(SIZE_MAX)) {
    const auto observation = source.next();
    if (!observation) break;
    const double stamp_s = core::fromMrptTime(observation->timestamp);
    if (begin) std::exchange(begin, nullptr)(stamp_s);
    if (run.realtime) clock.waitFor(stamp_s);
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

/// Heights in the floor plan are over something.
void tellOfFloor(const pipeline::SlamSystem& slam) {
  constexpr double kTold_deg = 1.0;
  const auto* builder = slam.mapBuilder();
  if (builder == nullptr) return;
  const mapping::FloorSeen floor = builder->floorSeen();
  if (!floor.planTrouble.empty()) tellAtOnce("the map has no floor plan: " + floor.planTrouble);
  const double tilt_deg = floor.tilt_rad * 180.0 / M_PI;
  if (floor.keyframes > 0 && floor.seen == 0) {
    tellAtOnce("no image shows the floor: the floor plan takes it to be at z = 0 of the map frame");
  } else if (tilt_deg >= kTold_deg) {
    std::ostringstream text;
    text << "the floor lies tilted by " << std::fixed << std::setprecision(1) << tilt_deg
         << " degrees in the map frame (map_frame.start_pose?): the floor plan counts heights from the floor as it "
            "was seen";
    tellAtOnce(text.str());
  }
}

void tellOfSensors(const sources::SensorCounts& sensors, const std::filesystem::path& input) {
  if (const auto sentence = sensors.sentence()) tellAtOnce(input.string() + ": " + *sentence);
}

/// The depth network saw nothing there, and nobody else says who moves by himself.
void tellWhatHadNoDepth(const pipeline::RunStatistics& statistics) {
  const auto found = statistics.events().find("segmentation.no_depth");
  if (found == statistics.events().end()) return;
  tellAtOnce(std::to_string(found->second) + " of " + std::to_string(statistics.frames()) +
             " images had too little depth for the network: in these, geometry alone told what moves");
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

/// Tracking was lost and begun anew: no failure of the run, but nobody should find it out by the missing half.
void tellOfPieces(const pipeline::SlamSystem& slam, const std::filesystem::path& folder, std::size_t frames) {
  const auto unjoined = slam.unjoinedTrajectories();
  if (unjoined.empty()) return;
  std::size_t elsewhere = 0;
  for (const auto& [piece, trajectory] : unjoined) elsewhere += trajectory.size();
  std::cerr << "wardslam: " << elsewhere << " of " << frames
            << " frames are not in the map: tracking was lost and begun "
            << "anew, and no place was recognised since; "
            << (unjoined.size() == 1 ? "that piece is" : "those pieces are") << " stored beside the map and as "
            << (folder / "trajectory_piece_*.txt").string() << "\n";
}

storage::MapFileWriter openMapFile(const RecordedRun& run, const pipeline::SlamSystem& slam,
                                   const std::optional<storage::MapCopy>& copy) {
  if (copy) return storage::MapFileWriter(storage::MapFile::open(copy->path(), storage::MapAccess::Write));
  return {run.out / "map.wardmap",
          storage::MapHeader{slam.labelSpace(), pipeline::withoutFolders(slam.configuration())}};
}

pipeline::EarlierMap earlierMapOf(const RecordedRun& run) {
  if (run.map.empty()) return {};
  return pipeline::readEarlierMap(run.map, run.localize ? graph::Saved::IsHeld : graph::Saved::MayChange);
}

/// What goes on in a map changes a copy of it, which takes its place once it has grown by this run.
void settle(const storage::MapCopy& copy, bool isRecognised) {
  if (isRecognised) {
    copy.takePlace();
  } else {
    copy.remove();
  }
}

/// Without a place in common, the poses of the run say nothing about the map.
void requireRecognition(const RecordedRun& run, const pipeline::SlamSystem& slam) {
  if (run.map.empty() || slam.recognisedAt_s()) return;
  throw core::InputError(run.map.string() + ": no place of this map was recognised in " + run.input.string() +
                         "; the trajectory is in a frame of its own and the map is as it was");
}

/// Images that came too late for a robot; a recording waits until they are worked in.
pipeline::WhenBehind whenBehind(const RecordedRun& run, bool isLive) {
  return isLive || run.realtime ? pipeline::WhenBehind::LeavesViewsOut : pipeline::WhenBehind::Waits;
}

/// Masks that are numbered belong to images that are: unless the configuration says otherwise, both count at one rate.
pipeline::SlamOptions withRateOfMasks(pipeline::SlamOptions options, double rate_hz) {
  double& ofMasks = options.segmentation.recorded_masks.rate_hz;
  if (ofMasks == segmentation::RecordedMasksOptions().rate_hz) ofMasks = rate_hz;
  return options;
}

PictureOptions pictureOptions(const RecordedRun& run) { return {run.pictureInterval, run.keepPeople}; }

/// One run, from the opened input to the written folder. Whatever goes wrong while it is tracked, what went well until
/// then is written first.
class Execution {
 public:
  Execution(const RecordedRun& run, const InterruptionGuard& interruption)
      : run_(run), interruption_(interruption), slam_(makeSystem()), truth_(makeTruth()), folder_(run.out, slam_) {
    const std::string configuration = slam_.configuration();
    folder_.writeConfiguration(run.isPrivate ? pipeline::withoutFolders(configuration) : configuration);
    watch();
    openMap();
  }

  /// False: interrupted.
  bool perform() {
    track();
    finishMap();
    isInterrupted_ = interruption_.requested();
    writeFolder();
    writePage();
    if (live_) std::cerr << "wardslam: " << live_->closingLine(statistics_.frames()) << "\n";
    tellOfSensors(source().sensors(), run_.input);
    failure_.rethrow();
    requireThatAllWasSound();
    tellWhatIsNotInTheMap();
    return !isInterrupted_;
  }

 private:
  pipeline::SlamSystem makeSystem() {
    if (sources::isSensorConfiguration(run_.input)) {
      live_.emplace(run_.input, run_.live, run_.options.sources.live, sourceOptions(run_, trouble_), interruption_);
    } else {
      recording_ = openRecording(run_, trouble_);
    }
    return pipeline::SlamSystem(withRateOfMasks(run_.options, source().rate_hz()), earlierMapOf(run_),
                                whenBehind(run_, live_.has_value()));
  }
  [[nodiscard]] std::unique_ptr<DynamicTruth> makeTruth() {
    if (run_.dynamicTruth.empty()) return nullptr;
    return std::make_unique<DynamicTruth>(run_.dynamicTruth, source().rate_hz());
  }
  sources::ObservationSource& source() { return live_ ? live_->source() : *recording_; }

  void watch() {
    slam_.setSensorTraits(source().sensorTraits());
    slam_.addObserver(statistics_);
    slam_.addObserver(stillCamera_);
    slam_.addObserver(zones_);
    slam_.addObserver(folder_);
    if (live_) slam_.addObserver(*live_);
    slam_.addObserver(pictures_);
    if (run_.view) slam_.addObserver(window_.emplace(slam_.labelSpace()));
    if (truth_) slam_.addObserver(*truth_);
  }

  void openMap() {
    if (!slam_.buildsSemanticMap()) return;
    if (!run_.map.empty()) mapCopy_.emplace(run_.map);
    if (mapCopy_ && mapCopy_->leftBehind()) {
      tellAtOnce("an earlier run on " + run_.map.string() + " was killed; the map it had made by then is kept as " +
                 mapCopy_->leftBehind()->string());
    }
    mapFile_.emplace(openMapFile(run_, slam_, mapCopy_));
    mapFile_->setWarningSink(tellAtOnce);
    slam_.writeTo(*mapFile_);
  }

  void track() {
    attempt([this] {
      processAll(source(), slam_, statistics_, trouble_, run_, interruption_,
                 [this](double start_s) { begin(start_s); });
    });
    if (live_) live_->source().close();
    attempt([this] { slam_.finish(); });
  }

  /// Before the first image is worked on.
  void begin(double start_s) {
    if (!run_.isPrivate) return;
    folder_.setStampOrigin(start_s);
    pictures_.setStampOrigin(start_s);
    if (mapFile_) mapFile_->setStampOrigin(start_s);
  }

  void finishMap() {
    if (!mapFile_) return;
    failure_.attempt([this] {
      attemptRun(run_, statistics_, [this] { mapFile_->finish(*slam_.mapBuilder(), slam_.mapper()); });
      if (mapCopy_) settle(*mapCopy_, slam_.recognisedAt_s().has_value());
    });
  }

  void writeFolder() {
    failure_.attempt([this] {
      folder_.finish({statistics_, zones_, source().damage(), slam_, mapFile_ ? mapFile_->failedWrites() : 0,
                      truth_.get(), live_ ? &*live_ : nullptr, pictureOptions(run_), isInterrupted_,
                      run_.options.deterministic, source().sensors()});
    });
  }

  void writePage() {
    if (!run_.report) return;
    ReportRequest request;
    request.folder = run_.out;
    request.map = run_.map;
    request.keepPeople = run_.keepPeople;
    const auto truth = run_.input / "groundtruth.txt";  // of a TUM folder
    if (!run_.isPrivate && std::filesystem::exists(truth)) request.groundTruth = truth;
    failure_.attempt([&] { writeReport(request); });
  }

  void tellWhatIsNotInTheMap() const {
    tellOfPieces(slam_, run_.out, statistics_.frames());
    tellWhatWasLeftOut(slam_.leftOut());
    tellOfFloor(slam_);
    tellWhatHadNoDepth(statistics_);
  }

  void requireThatAllWasSound() {
    if (!isInterrupted_) slam_.requireSoundSetup();
    requireSoundInput(source(), statistics_, trouble_, run_.input);
    if (!isInterrupted_) requireRecognition(run_, slam_);
    if (truth_ && statistics_.frames() > 0 && truth_->frames() == 0) {
      throw core::InputError(run_.dynamicTruth.string() +
                             ": no image belongs to any frame; they must be named by the stamps of the colour images");
    }
  }

  void attempt(const std::function<void()>& work) {
    failure_.attempt([&] { attemptRun(run_, statistics_, work); });
  }

  const RecordedRun& run_;
  const InterruptionGuard& interruption_;
  InputTrouble trouble_;
  std::optional<LiveRun> live_;
  std::unique_ptr<sources::ObservationSource> recording_;
  std::optional<storage::MapCopy> mapCopy_;
  std::optional<storage::MapFileWriter> mapFile_;  // outlives the system that writes to it
  pipeline::SlamSystem slam_;
  std::unique_ptr<DynamicTruth> truth_;  ///< Null: not compared.
  RunFolder folder_;
  pipeline::RunStatistics statistics_;
  StillCamera stillCamera_{tellAtOnce};
  PictureWriter pictures_{run_.out / "pictures", pictureOptions(run_), slam_.labelSpace()};
  pipeline::ZoneWatch zones_{slam_.zones()};
  std::optional<viewer::LiveWindow> window_;
  core::FirstFailure failure_;
  bool isInterrupted_ = false;
};

}  // namespace

bool perform(const RecordedRun& run, const InterruptionGuard& interruption) {
  return Execution(run, interruption).perform();
}

}  // namespace wardslam::apps
