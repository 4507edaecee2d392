#include "annotation_run.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <chrono>
#include <deque>
#include <iostream>
#include <iterator>

#include "blanking.h"
#include "output_files.h"
#include "support/progress.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/scan_annotator.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/sources/rawlog_reader.h"

namespace wardslam::rawlog_annotate {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CSensoryFrame;
using mrpt::serialization::CSerializable;
using mrpt_plugin::CObservationSemanticRGBD;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kBetweenCheckpoints{1};
constexpr std::size_t kWarmUp = 30;  // scans, about a second: what filters remember of motion

/// What must be the same for one run to go on where another was interrupted.
std::string describe(const AnnotationJob& job, const mrpt_plugin::ScanAnnotator& annotator) {
  return "version " WARDSLAM_VERSION "\ninput " + fs::absolute(job.input).string() + "\nsize " +
         std::to_string(fs::file_size(job.input)) + "\nchanged " +
         std::to_string(fs::last_write_time(job.input).time_since_epoch().count()) + "\nsensor " + job.sensorLabel +
         "\nembed " + std::to_string(static_cast<int>(job.embed)) + "\npeople " +
         std::to_string(static_cast<int>(job.keepPeople)) + "\n" + core::writeOptions(job.options) +
         annotator.parameters();
}

std::vector<CObservation3DRangeScan::Ptr> scansIn(const CSerializable::Ptr& object) {
  std::vector<CObservation3DRangeScan::Ptr> scans;
  for (const auto& observation : sources::observationsIn(object)) {
    if (auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) scans.push_back(std::move(scan));
  }
  return scans;
}

bool isOurs(const CSerializable::Ptr& object) {
  return std::dynamic_pointer_cast<CObservationSemanticRGBD>(object) != nullptr;
}

void replaceFindings(CSensoryFrame& frame, const std::vector<CObservationSemanticRGBD::Ptr>& found) {
  for (auto it = frame.begin(); it != frame.end();) it = isOurs(*it) ? frame.erase(it) : std::next(it);
  for (const auto& semantic : found) frame.insert(semantic);
}

/// The work of one run: object by object from the input to the output.
class Run {
 public:
  explicit Run(const AnnotationJob& job)
      : input_(job.input),
        annotator_(job.options, job.sensorLabel),
        reader_(job.input),
        files_(job.output, !job.embed, job.input, describe(job, annotator_)),
        embed_(job.embed),
        keepPeople_(job.keepPeople) {}

  /// Of what was interrupted, and of what the disk did not take, the next run makes use.
  AnnotationReport perform(const apps::InterruptionGuard& interruption) {
    try {
      return annotateAll(interruption);
    } catch (const core::InputError&) {
      if (!interruption.requested()) files_.discard();
      throw;
    }
  }

 private:
  AnnotationReport annotateAll(const apps::InterruptionGuard& interruption) {
    std::string trouble;
    try {
      skipWhatIsDone();
      workThrough(interruption);
    } catch (const sources::InputDamage& damage) {
      // Of a rawlog that is cut off nothing more can be had; behind an unknown object there may be hours.
      if (damage.event() == "sources.rawlog_unknown_class" || damage.event() == "sources.rawlog_newer")
        throw core::InputError(input_.string() + ": " + damage.what());
      trouble = damage.what();
    }
    if (reader_.objects() == 0) throw core::InputError(input_.string() + ": is empty or not a rawlog");
    requireSensor();
    annotator_.requireSoundSetup();
    files_.commit();
    return {reader_.objects(),
            files_.objectsDone(),
            annotator_.annotated() - warmUps_,
            embed_ ? fs::path() : files_.sidecar(),
            annotator_.events(),
            sensors_,
            trouble.empty() ? annotator_.firstTrouble() : trouble};
  }

  void requireSensor() const {
    const auto& known = sensors_.observations;
    if (sensors_.taken.empty() || known.empty() || known.count(sensors_.taken) > 0) return;
    throw core::InputError(input_.string() + ": has no RGB-D sensor '" + sensors_.taken +
                           "'; give one of these with --sensor: " + sensors_.labels());
  }

  /// Filters the last scans of what is done once more: they know then what was moving.
  void skipWhatIsDone() {
    std::deque<CObservation3DRangeScan::Ptr> last;
    while (reader_.objects() < files_.objectsDone()) {
      const auto object = reader_.read();
      if (!object) break;
      for (const auto& scan : scansIn(object)) last.push_back(scan);
      while (last.size() > kWarmUp) last.pop_front();
    }
    for (const auto& scan : last) static_cast<void>(annotator_.annotate(scan));
    warmUps_ = annotator_.annotated();
  }

  void workThrough(const apps::InterruptionGuard& interruption) {
    apps::Progress progress(std::cerr, apps::standardErrorIsTerminal(), "scan", std::nullopt);
    const double begin = reader_.fraction();
    auto nextCheckpoint = Clock::now() + kBetweenCheckpoints;
    while (const auto object = reader_.read()) {
      handle(object);
      progress.update(annotator_.annotated() - warmUps_, (reader_.fraction() - begin) / (1.0 - begin));
      if (interruption.requested() || Clock::now() >= nextCheckpoint) {
        files_.checkpoint(reader_.objects());
        nextCheckpoint = Clock::now() + kBetweenCheckpoints;
      }
      if (interruption.requested()) {
        throw core::InputError("interrupted after " + std::to_string(reader_.objects()) +
                               " objects, which are kept; the same command goes on from there");
      }
    }
  }

  void handle(const CSerializable::Ptr& object) {
    if (isOurs(object)) return;  // embedded by an earlier run
    std::vector<CObservationSemanticRGBD::Ptr> found;
    for (const auto& scan : scansIn(object)) {
      if (scan->hasIntensityImage && scan->hasRangeImage) ++sensors_.observations[scan->sensorLabel];
      if (auto semantic = annotator_.annotate(scan)) {
        if (!keepPeople_) blankPeople(*scan, *semantic);
        found.push_back(std::move(semantic));
      }
      sensors_.taken = annotator_.sensorLabel();
      scan->unload();  // what is stored outside stays there
    }
    if (found.empty()) return files_.write(reader_.bytes());
    const auto sensoryFrame = std::dynamic_pointer_cast<CSensoryFrame>(object);
    if (sensoryFrame) replaceFindings(*sensoryFrame, embed_ ? found : std::vector<CObservationSemanticRGBD::Ptr>{});
    files_.write(*object);
    for (const auto& semantic : found) {
      if (!embed_) files_.writeToSidecar(*semantic);
      if (embed_ && !sensoryFrame) files_.write(*semantic);
    }
  }

  fs::path input_;
  mrpt_plugin::ScanAnnotator annotator_;
  sources::RawlogReader reader_;
  OutputFiles files_;
  bool embed_;
  bool keepPeople_;
  sources::SensorCounts sensors_;
  std::size_t warmUps_ = 0;
};

}  // namespace

AnnotationReport annotateRawlog(const AnnotationJob& job, const apps::InterruptionGuard& interruption) {
  return Run(job).perform(interruption);
}

}  // namespace wardslam::rawlog_annotate
