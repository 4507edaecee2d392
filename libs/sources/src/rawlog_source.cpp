#include "wardslam/sources/rawlog_source.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <regex>
#include <utility>

#include "external_images.h"
#include "input_damage.h"
#include "observation_check.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::serialization::CSerializable;

/// The class named in MRPT's complaint about an object it cannot create.
std::optional<std::string> unregisteredClass(const std::string& complaint) {
  static const std::regex kComplaint("class '([^']*)' which is not registered");
  std::smatch match;
  if (!std::regex_search(complaint, match, kComplaint)) return std::nullopt;
  return match[1].str();
}

void replaceCamera(CObservation3DRangeScan& scan, const core::CameraModel& camera) {
  scan.cameraParamsIntensity = core::toMrpt(camera);
  if (scan.doDepthAndIntensityCamerasCoincide()) scan.cameraParams = scan.cameraParamsIntensity;
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

/// The objects of the file, one after the other. Holds no more than one.
class RawlogSource::ObjectReader {
 public:
  explicit ObjectReader(const fs::path& file) {
    if (!fs::is_regular_file(file) || !in_.open(file.string())) {
      throw core::InputError(file.string() + ": cannot be opened as a rawlog file");
    }
  }

  /// Null at the end of the file. Throws InputDamage where the next object cannot be read; after that, null.
  [[nodiscard]] CSerializable::Ptr read() {
    if (ended_) return nullptr;
    const auto start = in_.getPosition();
    try {
      auto object = archive_.ReadObject();
      ++objects_;
      return object;
    } catch (const std::exception& error) {
      ended_ = true;
      if (const auto name = unregisteredClass(error.what())) {
        throw InputDamage("sources.rawlog_unknown_class", "holds an object of class " + *name +
                                                              ", which this program does not know; remove such " +
                                                              "objects with rawlog-edit and the plug-in that has it");
      }
      if (in_.getPosition() == start) return nullptr;  // not one byte of a further object: a proper end
      throw InputDamage("sources.rawlog_truncated", "is cut off or damaged; copy or record it again");
    }
  }

  [[nodiscard]] std::size_t objects() const { return objects_; }

 private:
  mrpt::io::CFileGZInputStream in_;
  mrpt::serialization::CArchiveStreamBase<mrpt::io::CFileGZInputStream> archive_{in_};
  bool ended_ = false;
  std::size_t objects_ = 0;
};

RawlogSource::RawlogSource(const fs::path& file, const SourceOptions& options)
    : file_(file), reader_(std::make_unique<ObjectReader>(file)), damage_(std::make_unique<DamageLog>(options.warn)) {
  if (options.camera) camera_ = readRgbdCamera(*options.camera);
  if (const auto images = findImageFolder(file)) mrpt::img::CImage::setImagesPathBase(images->string());
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
  const auto take = [this](const CSerializable::Ptr& object) {
    if (auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(object)) {
      pending_.push_back(std::move(scan));
    } else {
      passedOver_.insert(object->GetRuntimeClass()->className);
    }
  };
  try {
    const auto object = reader_->read();
    if (!object) return false;
    const auto sensoryFrame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object);
    if (!sensoryFrame) {
      take(object);
      return true;
    }
    for (const auto& observation : *sensoryFrame) take(observation);
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
