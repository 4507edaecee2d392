#include "rawlog_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <cmath>
#include <utility>

#include "observation_camera.h"
#include "observation_check.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/sources/rawlog_reader.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationStereoImages;

constexpr const char* kNewerEvent = "sources.rawlog_newer";

/// What to do where images are stored outside the rawlog and nothing like their folder is there.
std::string missingFolder(const fs::path& rawlog, const std::string& event) {
  if (event != "sources.image_missing" || findImageFolder(rawlog)) return "";
  const std::string name = rawlog.stem().string() + "_Images";
  return "; its images are stored outside of it, in a folder " + name + " beside it, which is not there: put it back " +
         "under that name";
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

RawlogSource::RawlogSource(const fs::path& file, const SourceOptions& options)
    : file_(file),
      note_(options.note),
      depth_units_per_m_(options.depth_units_per_m),
      reader_(std::make_unique<RawlogReader>(file)),
      damage_(std::make_unique<DamageLog>(options.warn)),
      stereo_(options.stereo) {
  if (!options.sensor.empty()) label_ = options.sensor;
  if (options.camera) {
    camera_ = readRgbdCamera(*options.camera, options.note);
    if (camera_->color.width_px == 0) {
      throw core::InputError(options.camera->string() + ": does not tell the size of the images it is for; add it");
    }
    traits_ = camera_->color.traits();
  }
  first_ = readScan();
  if (!first_) failWithoutScans();
  tellOfUnit(*first_);
}

RawlogSource::~RawlogSource() = default;

void RawlogSource::tellOfUnit(const CObservation3DRangeScan& scan) const {
  const double camera_per_m = camera_ && !depth_units_per_m_ ? camera_->depth_units_per_m : 0.0;
  const auto unit_m = static_cast<double>(scan.rangeUnits);
  if (camera_per_m == 0.0 || std::abs(camera_per_m * unit_m - 1.0) < 1e-3) return;
  const auto text = [](double number) { return std::to_string(std::lround(number)); };
  note_(file_.string() + ": tells that its depth has " + text(1.0 / unit_m) + " units a metre, which counts, and not " +
        text(camera_per_m) + ", as the camera file says; --depth-factor N changes that");
}

std::shared_ptr<CObservation3DRangeScan> RawlogSource::next() {
  if (first_) return std::exchange(first_, nullptr);
  return readScan();
}

const core::EventCounts& RawlogSource::damage() const { return damage_->counts(); }

RawlogSource::ScanPtr RawlogSource::readScan() {
  do {
    while (!pending_.empty()) {
      const ObservationPtr observation = std::move(pending_.front());
      pending_.pop_front();
      if (auto scan = takeIfUsable(observation)) return scan;
    }
  } while (fillPending());
  return nullptr;
}

/// Reads one object; false at the end.
bool RawlogSource::fillPending() {
  try {
    const auto object = reader_->read();
    if (!object) return false;
    const auto observations = observationsIn(object);
    if (observations.empty()) passedOver_.insert(object->GetRuntimeClass()->className);
    for (const auto& observation : observations) {
      if (std::dynamic_pointer_cast<CObservation3DRangeScan>(observation) ||
          std::dynamic_pointer_cast<CObservationStereoImages>(observation)) {
        pending_.push_back(observation);
      } else {
        passedOver_.insert(observation->GetRuntimeClass()->className);
      }
    }
    return true;
  } catch (const InputDamage& damage) {
    const std::string when = " (after " + std::to_string(scansRead_) + " RGB-D observations)";
    if (damage.event() == kNewerEvent) newer_ = damage.what();
    damage_->add(damage.event(), file_.string() + ": " + damage.what() + when);
    return false;
  }
}

/// Null for an observation that is passed over or left out.
RawlogSource::ScanPtr RawlogSource::takeIfUsable(const ObservationPtr& observation) {
  const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation);
  if (scan && !(scan->hasIntensityImage && scan->hasRangeImage)) {
    passedOver_.insert("scans without both images");
    return nullptr;
  }
  ++sensors_.observations[observation->sensorLabel];
  if (label_ && *label_ != observation->sensorLabel) return nullptr;
  ++scansRead_;
  try {
    const ScanPtr prepared = scan ? prepare(scan) : prepare(dynamic_cast<CObservationStereoImages&>(*observation));
    requireOrderOfTime(*prepared);
    label_ = sensors_.taken = observation->sensorLabel;
    mayStop_ = false;
    if (const auto sentence = scaleCheck_.add(*prepared)) note_(file_.string() + ": " + *sentence);
    return prepared;
  } catch (const InputDamage& damage) {
    const std::string what = "observation " + std::to_string(scansRead_) + ": " + damage.what();
    if (firstDamage_.empty()) firstDamage_ = what;
    damage_->add(damage.event(), file_.string() + ": " + what + "; it is left out, as are others like it");
    stopIfAllFail(damage.event(), what);
    return nullptr;
  }
}

void RawlogSource::stopIfAllFail(const std::string& event, const std::string& what) {
  if (scansRead_ == 1) failingAlike_ = event;
  mayStop_ = mayStop_ && failingAlike_ == event;
  if (!mayStop_ || scansRead_ < kPatience) return;
  throw core::InputError(file_.string() + ": " + what + missingFolder(file_, event) +
                         "; so it is with all of the first " + std::to_string(kPatience) +
                         " observations, and nothing was tracked");
}

RawlogSource::ScanPtr RawlogSource::prepare(const ScanPtr& scan) const {
  loadImages(*scan);
  if (depth_units_per_m_) scan->rangeUnits = static_cast<float>(1.0 / *depth_units_per_m_);
  if (camera_) replaceCamera(*scan, camera_->color);
  if (const auto reason = whyUnusable(*scan)) throw InputDamage("sources.observation_unusable", *reason);
  return scan;
}

RawlogSource::ScanPtr RawlogSource::prepare(const CObservationStereoImages& pair) {
  if (camera_) {
    throw core::InputError(file_.string() + ": was recorded by a stereo camera, which a camera file cannot describe; " +
                           "correct its calibration with rawlog-edit --camera-params instead of giving --camera");
  }
  loadImages(pair);
  try {
    auto scan = stereo_.convert(pair);
    if (!label_) traits_.depthNoise = stereo_.noise();
    return scan;
  } catch (const core::FrameError& error) {
    throw InputDamage("sources.observation_unusable", error.what());
  }
}

void RawlogSource::requireOrderOfTime(const CObservation3DRangeScan& scan) {
  const double stamp_s = core::fromMrptTime(scan.timestamp);
  if (lastStamp_s_ && stamp_s < *lastStamp_s_) {
    throw InputDamage("sources.stamp_goes_back", "was taken " + std::to_string(*lastStamp_s_ - stamp_s) +
                                                     " s before the one that stands before it");
  }
  lastStamp_s_ = stamp_s;
}

void RawlogSource::failWithoutScans() const {
  const std::string file = file_.string();
  if (!newer_.empty()) throw core::InputError(file + ": " + newer_);
  if (scansRead_ == 0 && label_ && !sensors_.observations.empty()) {
    throw core::InputError(file + ": has no RGB-D sensor '" + *label_ +
                           "'; give one of these with --sensor: " + sensors_.labels());
  }
  if (reader_->objects() == 0) {
    const bool isUnknownClass = damage_->counts().count("sources.rawlog_unknown_class") > 0;
    throw core::InputError(file + (isUnknownClass ? ": begins with an object of a class that is not linked in"
                                                  : ": is empty or not a rawlog"));
  }
  if (scansRead_ > 0)
    throw core::InputError(file + ": none of its RGB-D or stereo observations can be used; " + firstDamage_ +
                           missingFolder(file_, failingAlike_));
  throw core::InputError(file + ": holds no CObservation3DRangeScan with an intensity and a range image and no " +
                         "CObservationStereoImages" + (passedOver_.empty() ? "" : ", only: " + joined(passedOver_)));
}

}  // namespace wardslam::sources
