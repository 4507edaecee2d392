#include "wardslam/sources/rawlog_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <utility>

#include "observation_camera.h"
#include "observation_check.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/sources/rawlog_reader.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

RawlogSource::RawlogSource(const fs::path& file, const SourceOptions& options)
    : file_(file), reader_(std::make_unique<RawlogReader>(file)), damage_(std::make_unique<DamageLog>(options.warn)) {
  if (options.camera) camera_ = readRgbdCamera(*options.camera);
  first_ = readScan();
  if (!first_) failWithoutScans();
}

RawlogSource::~RawlogSource() = default;

std::shared_ptr<CObservation3DRangeScan> RawlogSource::next() {
  if (first_) return std::exchange(first_, nullptr);
  return readScan();
}

const core::EventCounts& RawlogSource::damage() const { return damage_->counts(); }

RawlogSource::ScanPtr RawlogSource::readScan() {
  do {
    while (!pending_.empty()) {
      ScanPtr scan = std::move(pending_.front());
      pending_.pop_front();
      if (isUsable(*scan)) return scan;
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
      if (auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) {
        pending_.push_back(std::move(scan));
      } else {
        passedOver_.insert(observation->GetRuntimeClass()->className);
      }
    }
    return true;
  } catch (const InputDamage& damage) {
    const std::string when = " (after " + std::to_string(scansRead_) + " RGB-D observations)";
    damage_->add(damage.event(), file_.string() + ": " + damage.what() + when);
    return false;
  }
}

bool RawlogSource::isUsable(CObservation3DRangeScan& scan) {
  if (!scan.hasIntensityImage || !scan.hasRangeImage) {
    passedOver_.insert("scans without both images");
    return false;
  }
  if (label_ && *label_ != scan.sensorLabel) return false;
  ++scansRead_;
  try {
    loadImages(scan);
    if (camera_) replaceCamera(scan, camera_->color);
    if (const auto reason = whyUnusable(scan)) throw InputDamage("sources.observation_unusable", *reason);
  } catch (const InputDamage& damage) {
    damage_->add(damage.event(), file_.string() + ": observation " + std::to_string(scansRead_) + ": " + damage.what() +
                                     "; it is left out, as are others like it");
    return false;
  }
  label_ = scan.sensorLabel;
  return true;
}

void RawlogSource::failWithoutScans() const {
  const std::string file = file_.string();
  if (reader_->objects() == 0) {
    const bool isUnknownClass = damage_->counts().count("sources.rawlog_unknown_class") > 0;
    throw core::InputError(file + (isUnknownClass ? ": begins with an object of a class that is not linked in"
                                                  : ": is empty or not a rawlog"));
  }
  if (scansRead_ > 0) throw core::InputError(file + ": none of its RGB-D observations can be used");
  throw core::InputError(file + ": holds no CObservation3DRangeScan with an intensity and a range image" +
                         (passedOver_.empty() ? "" : ", only: " + joined(passedOver_)));
}

}  // namespace wardslam::sources
