#include "wardslam/sources/bag_observations.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <set>
#include <utility>

#include "bag_rig.h"
#include "bag_streams.h"
#include "bag_survey.h"
#include "depth_scale_check.h"
#include "observation_check.h"
#include "wardslam/bags/image_decoding.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/rgbd_camera.h"

namespace wardslam::sources {
namespace {

using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationIMU;
using mrpt::obs::CObservationOdometry;

std::optional<RgbdCamera> givenCamera(const SourceOptions& options) {
  if (!options.camera) return std::nullopt;
  const RgbdCamera camera = readRgbdCamera(*options.camera, options.note);
  if (camera.color.width_px > 0) return camera;
  throw core::InputError(options.camera->string() + ": does not tell the size of the images it is for; add it");
}

/// What is to be made of one or two messages.
struct Item {
  enum class Kind { Scan, Odometry, Imu };
  Kind kind = Kind::Scan;
  double stamp_s = 0.0;
  std::size_t entry = 0;
  std::size_t depthEntry = 0;
};

void setField(CObservationIMU& imu, mrpt::obs::TIMUDataIndex field, double value) {
  imu.rawMeasurements.at(field) = value;
  imu.dataIsPresent.at(field) = true;
}

}  // namespace

class BagObservations::Reading {
 public:
  Reading(const std::filesystem::path& file, const SourceOptions& options)
      : file_(file.string()),
        note_(options.note),
        damage_(options.warn),
        bag_(bags::openBag(file)),
        given_(givenCamera(options)) {
    for (const bags::BagDamage& found : bag_->damage()) damage_.add(found.event(), file_ + ": " + found.what());
    streams_ = findStreams(*bag_, options.topics, !given_, file_, note_);
    const BagSurvey found = survey(*bag_, streams_, file_, damage_);
    const auto color = given_ ? std::optional(given_->color) : std::nullopt;
    rig_ = rigOf(found, topic(streams_.color).name, topic(streams_.depth).name, color, file_);
    transforms_ = found.transforms;
    unit_m_ = found.depthUnit_m;
    isUnitGiven_ = options.depth_units_per_m.has_value();
    if (isUnitGiven_) unit_m_ = 1.0 / *options.depth_units_per_m;
    plan(found);
    tell(found);
  }

  std::shared_ptr<CObservation> next() {
    while (nextItem_ < items_.size()) {
      const Item& item = items_[nextItem_++];
      std::size_t reading = item.entry;
      try {
        return make(item, reading);
      } catch (const bags::BagDamage& trouble) {
        damage_.add(trouble.event(), file_ + ": " + nameOf(*bag_, reading) + ": " + trouble.what() +
                                         "; it is left out, as are others like it");
      } catch (const InputDamage& trouble) {
        damage_.add(trouble.event(), file_ + ": " + nameOf(*bag_, reading) + ": " + trouble.what() +
                                         "; it is left out, as are others like it");
      }
    }
    return nullptr;
  }

  void passOverAllButScans() {
    items_.erase(
        std::remove_if(items_.begin(), items_.end(), [](const Item& item) { return item.kind != Item::Kind::Scan; }),
        items_.end());
  }

  [[nodiscard]] std::size_t scans() const { return scans_; }
  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] const core::EventCounts& damage() const { return damage_.counts(); }
  [[nodiscard]] core::SensorTraits sensorTraits() const { return rig_.color.traits(); }

 private:
  [[nodiscard]] const bags::Topic& topic(std::size_t index) const { return bag_->topics()[index]; }

  void plan(const BagSurvey& found) {
    for (const auto& [color, depth] : found.pairs) {
      items_.push_back(
          {Item::Kind::Scan, found.colors[color].stamp_s, found.colors[color].entry, found.depths[depth].entry});
    }
    scans_ = items_.size();
    for (const BagMessage& reading : found.odometries)
      items_.push_back({Item::Kind::Odometry, reading.stamp_s, reading.entry, 0});
    for (const BagMessage& reading : found.imus) items_.push_back({Item::Kind::Imu, reading.stamp_s, reading.entry, 0});
    std::stable_sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) { return a.stamp_s < b.stamp_s; });
  }

  void tell(const BagSurvey& found) const {
    std::string sentence =
        file_ + ": takes colour from " + topic(streams_.color).name + ", depth from " + topic(streams_.depth).name;
    if (!given_) sentence += ", and the calibration from " + topic(*streams_.colorInfo).name;
    const std::size_t images = std::min(found.colors.size(), found.depths.size());
    if (2 * found.pairs.size() < images) {
      sentence += "; only " + std::to_string(found.pairs.size()) + " of " + std::to_string(images) +
                  " images have a partner within 0.02 s";
    }
    note_(sentence + rig_.assumed);
  }

  /// `reading`: the entry that is read, to be named where that fails.
  std::shared_ptr<CObservation> make(const Item& item, std::size_t& reading) {
    std::shared_ptr<CObservation> observation;
    switch (item.kind) {
      case Item::Kind::Scan:
        observation = makeScan(item, reading);
        break;
      case Item::Kind::Odometry:
        observation = makeOdometry(item);
        break;
      case Item::Kind::Imu:
        observation = makeImu(item);
        break;
    }
    observation->timestamp = core::toMrptTime(item.stamp_s);
    observation->sensorLabel = topic(bag_->entries()[item.entry].topic).name;
    return observation;
  }

  std::shared_ptr<CObservation> makeScan(const Item& item, std::size_t& reading) {
    auto scan = CObservation3DRangeScan::Create();
    scan->timestamp = core::toMrptTime(item.stamp_s);
    scan->hasIntensityImage = true;
    scan->intensityImage = mrpt::img::CImage(readColor(item.entry), mrpt::img::SHALLOW_COPY);
    reading = item.depthEntry;
    const bags::DepthImage depth = readDepth(item.depthEntry);
    scan->hasRangeImage = true;
    scan->range_is_depth = true;
    scan->rangeUnits = static_cast<float>(depth.unit_m);
    scan->rangeImage_setSize(depth.units.rows, depth.units.cols);
    depth.units.copyTo(cv::Mat(depth.units.size(), CV_16UC1, scan->rangeImage.data()));
    placeCameras(*scan);
    if (const auto reason = whyUnusable(*scan)) throw InputDamage("sources.observation_unusable", *reason);
    if (const auto sentence = scaleCheck_.add(*scan)) noteOnce(*sentence);
    return scan;
  }

  void placeCameras(CObservation3DRangeScan& scan) const {
    scan.cameraParamsIntensity = core::toMrpt(rig_.color);
    scan.cameraParams = core::toMrpt(rig_.depth);
    // One view point for both images is what relativePoseIntensityWRTDepth says by default.
    const Eigen::Isometry3d T_sensor_cam = core::T_sensor_cam();
    if (rig_.T_depth_color) scan.relativePoseIntensityWRTDepth = core::toMrpt(T_sensor_cam * *rig_.T_depth_color);
    if (!rig_.T_depth_color && !rig_.T_base_color) return;
    const Eigen::Isometry3d T_base_color = rig_.T_base_color.value_or(T_sensor_cam);
    const Eigen::Isometry3d T_color_depth =
        rig_.T_depth_color ? rig_.T_depth_color->inverse() : Eigen::Isometry3d::Identity();
    scan.sensorPose = core::toMrpt(T_base_color * T_color_depth * T_sensor_cam.inverse());
  }

  cv::Mat readColor(std::size_t entry) {
    const auto [message, about] = read(entry);
    if (about.type == "sensor_msgs/CompressedImage")
      return bags::decodeColor(bags::readCompressedImage(message, about.wire));
    const bags::Image image = bags::readImage(message, about.wire);
    if (image.encoding == "8UC3") noteOnce(about.name + " has the encoding 8UC3, which is taken for blue, green, red");
    return bags::decodeColor(image);
  }

  bags::DepthImage readDepth(std::size_t entry) {
    const auto [message, about] = read(entry);
    const bool isCompressed = about.type == "sensor_msgs/CompressedImage";
    bags::DepthImage depth = isCompressed ? bags::decodeDepth(bags::readCompressedImage(message, about.wire))
                                          : bags::decodeDepth(bags::readImage(message, about.wire));
    if (unit_m_ && !depth.isOfMetres) depth.unit_m = *unit_m_;
    tellOfUnit(depth, about.name);
    if (depth.tooFar > 0) noteOnce(about.name + " has depths beyond 13.1 m, which are left out");
    return depth;
  }

  /// Where somebody told of a unit that does not count.
  void tellOfUnit(const bags::DepthImage& depth, const std::string& name) {
    if (depth.isOfMetres) {
      if (isUnitGiven_) noteOnce(name + " is of floating-point metres, which --depth-factor does not change");
      return;
    }
    const double camera_per_m = given_ ? given_->depth_units_per_m : 0.0;
    if (isUnitGiven_ || camera_per_m == 0.0 || std::abs(camera_per_m * depth.unit_m - 1.0) < 1e-3) return;
    const auto text = [](double number) { return std::to_string(std::lround(number)); };
    noteOnce(name + " has " + text(1.0 / depth.unit_m) + " units a metre, as recordings of ROS have, and not " +
             text(camera_per_m) + ", as the camera file says; --depth-factor N changes that");
  }

  std::shared_ptr<CObservation> makeOdometry(const Item& item) {
    const auto [message, about] = read(item.entry);
    const bags::Odometry odometry = bags::readOdometry(message, about.wire);
    auto observation = CObservationOdometry::Create();
    observation->odometry = mrpt::poses::CPose2D(core::toMrpt(odometry.T_odom_child));
    observation->hasVelocities = true;
    observation->velocityLocal.vx = odometry.velocity_mps.x();
    observation->velocityLocal.vy = odometry.velocity_mps.y();
    observation->velocityLocal.omega = odometry.angularVelocity_radps.z();
    return observation;
  }

  std::shared_ptr<CObservation> makeImu(const Item& item) {
    using namespace mrpt::obs;  // NOLINT(google-build-using-namespace): the names of two dozen fields
    const auto [message, about] = read(item.entry);
    const bags::Imu imu = bags::readImu(message, about.wire);
    auto observation = CObservationIMU::Create();
    if (const auto& a = imu.acceleration_mps2) {
      setField(*observation, IMU_X_ACC, a->x());
      setField(*observation, IMU_Y_ACC, a->y());
      setField(*observation, IMU_Z_ACC, a->z());
    }
    if (const auto& w = imu.angularVelocity_radps) {
      setField(*observation, IMU_WX, w->x());
      setField(*observation, IMU_WY, w->y());
      setField(*observation, IMU_WZ, w->z());
    }
    if (const auto& q = imu.orientation) {
      setField(*observation, IMU_ORI_QUAT_X, q->x());
      setField(*observation, IMU_ORI_QUAT_Y, q->y());
      setField(*observation, IMU_ORI_QUAT_Z, q->z());
      setField(*observation, IMU_ORI_QUAT_W, q->w());
    }
    if (rig_.T_base_color) {
      const auto T_base_imu = transforms_.T(rig_.baseFrame, imu.header.frame);
      if (T_base_imu) observation->sensorPose = core::toMrpt(*T_base_imu);
    }
    return observation;
  }

  [[nodiscard]] std::pair<bags::Bytes, const bags::Topic&> read(std::size_t entry) {
    return {bag_->read(entry), topic(bag_->entries()[entry].topic)};
  }

  void noteOnce(const std::string& what) {
    if (told_.insert(what).second) note_(file_ + ": " + what);
  }

  std::string file_;
  NoteSink note_;
  std::optional<double> unit_m_;  ///< Replaces millimetres.
  bool isUnitGiven_ = false;      ///< By who asks, not by the recording.
  DamageLog damage_;
  DepthScaleCheck scaleCheck_;
  std::unique_ptr<bags::BagReader> bag_;
  std::optional<RgbdCamera> given_;
  BagStreams streams_;
  BagRig rig_;
  BagTransforms transforms_;
  std::vector<Item> items_;
  std::size_t scans_ = 0;
  std::size_t nextItem_ = 0;
  std::set<std::string> told_;
};

BagObservations::BagObservations(const std::filesystem::path& file, const SourceOptions& options)
    : reading_(std::make_unique<Reading>(file, options)) {}
BagObservations::~BagObservations() = default;

std::shared_ptr<CObservation> BagObservations::next() { return reading_->next(); }
void BagObservations::passOverAllButScans() { reading_->passOverAllButScans(); }
std::size_t BagObservations::scans() const { return reading_->scans(); }
std::size_t BagObservations::size() const { return reading_->size(); }
const core::EventCounts& BagObservations::damage() const { return reading_->damage(); }
core::SensorTraits BagObservations::sensorTraits() const { return reading_->sensorTraits(); }

}  // namespace wardslam::sources
