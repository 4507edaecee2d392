#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>

#include "output/recording.h"
#include "recording/rawlog_writer.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::synth {
namespace {

namespace obs = mrpt::obs;

constexpr double kRangeUnits_m = 0.001;

Bytes serialised(const mrpt::serialization::CSerializable& object) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  const auto* begin = static_cast<const std::uint8_t*>(stream.getRawBufferData());
  return {begin, begin + stream.getTotalBytesCount()};
}

/// By its angles: a level camera is written with plain zeros, not with signs that rounding left.
mrpt::poses::CPose3D byAngles(const Eigen::Isometry3d& T) {
  const auto& R = T.linear();
  const auto& p = T.translation();
  return {p.x(),
          p.y(),
          p.z(),
          std::atan2(R(1, 0), R(0, 0)),
          std::asin(std::clamp(0.0 - R(2, 0), -1.0, 1.0)),
          std::atan2(R(2, 1), R(2, 2))};
}

class RawlogRecording : public Recording {
 public:
  RawlogRecording(const std::filesystem::path& file, const SequenceCamera& camera)
      : camera_(core::toMrpt(camera.model)),
        stereoBaseline_m_(camera.stereoBaseline_m),
        sensorPose_(byAngles(camera.T_base_sensor)),
        writer_(file, recording::ImageCoding::Jpeg) {}

  [[nodiscard]] std::vector<Bytes> encode(const SequenceFrame& frame) const override {
    return {stereoBaseline_m_ ? serialised(stereoPair(frame)) : serialised(scan(frame))};
  }
  void writeFrame(double /*stamp_s*/, const std::vector<Bytes>& parts) override { writer_.write(parts.front()); }
  void writeOdometry(double stamp_s, const OdometryReading& reading) override;
  void writeImu(double stamp_s, const ImuReading& reading) override;
  void commit() override { writer_.commit(); }

 private:
  [[nodiscard]] obs::CObservation3DRangeScan scan(const SequenceFrame& frame) const;
  [[nodiscard]] obs::CObservationStereoImages stereoPair(const SequenceFrame& frame) const;

  mrpt::img::TCamera camera_;
  std::optional<double> stereoBaseline_m_;
  mrpt::poses::CPose3D sensorPose_;
  recording::RawlogWriter writer_;
};

obs::CObservation3DRangeScan RawlogRecording::scan(const SequenceFrame& frame) const {
  obs::CObservation3DRangeScan scan;
  scan.sensorLabel = "RGBD";
  scan.timestamp = core::toMrptTime(frame.stamp_s);
  scan.sensorPose = sensorPose_;
  scan.range_is_depth = true;
  scan.maxRange = 8.0F;
  scan.stdError = 0.01F;
  scan.cameraParams = camera_;
  scan.cameraParamsIntensity = camera_;
  scan.relativePoseIntensityWRTDepth = mrpt::poses::CPose3D(core::toMrpt(core::T_sensor_cam()));
  scan.intensityImageChannel = obs::CObservation3DRangeScan::CH_VISIBLE;
  scan.hasIntensityImage = true;
  scan.intensityImage = mrpt::img::CImage(frame.color_bgr, mrpt::img::SHALLOW_COPY);
  scan.hasRangeImage = true;
  scan.rangeUnits = static_cast<float>(kRangeUnits_m);
  scan.rangeImage.resize(frame.depth_m.rows, frame.depth_m.cols);
  cv::Mat range(frame.depth_m.size(), CV_16UC1, scan.rangeImage.data());
  frame.depth_m.convertTo(range, CV_16U, 1.0 / kRangeUnits_m);
  return scan;
}

obs::CObservationStereoImages RawlogRecording::stereoPair(const SequenceFrame& frame) const {
  obs::CObservationStereoImages pair;
  pair.sensorLabel = "STEREO";
  pair.timestamp = core::toMrptTime(frame.stamp_s);
  pair.cameraPose = mrpt::poses::CPose3DQuat(sensorPose_ + core::toMrpt(core::T_sensor_cam()));
  pair.rightCameraPose = mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(*stereoBaseline_m_, 0, 0, 0, 0, 0));
  pair.leftCamera = pair.rightCamera = camera_;
  pair.imageLeft = mrpt::img::CImage(frame.color_bgr, mrpt::img::SHALLOW_COPY);
  pair.imageRight = mrpt::img::CImage(frame.right_bgr, mrpt::img::SHALLOW_COPY);
  pair.hasImageRight = true;
  return pair;
}

void RawlogRecording::writeOdometry(double stamp_s, const OdometryReading& reading) {
  obs::CObservationOdometry odometry;
  odometry.sensorLabel = "ODOMETRY";
  odometry.timestamp = core::toMrptTime(stamp_s);
  odometry.odometry = mrpt::poses::CPose2D(reading.pose.x(), reading.pose.y(), reading.pose.z());
  odometry.hasVelocities = true;
  odometry.velocityLocal = {reading.velocity.x(), reading.velocity.y(), reading.velocity.z()};
  writer_.write(odometry);
}

void RawlogRecording::writeImu(double stamp_s, const ImuReading& reading) {
  obs::CObservationIMU imu;
  imu.sensorLabel = "IMU";
  imu.timestamp = core::toMrptTime(stamp_s);
  imu.sensorPose = sensorPose_;
  const auto set = [&](obs::TIMUDataIndex index, double value) {
    imu.dataIsPresent[static_cast<std::size_t>(index)] = true;
    imu.rawMeasurements[static_cast<std::size_t>(index)] = value;
  };
  set(obs::IMU_X_ACC, reading.specificForce.x());
  set(obs::IMU_Y_ACC, reading.specificForce.y());
  set(obs::IMU_Z_ACC, reading.specificForce.z());
  set(obs::IMU_WX, reading.angularVelocity.x());
  set(obs::IMU_WY, reading.angularVelocity.y());
  set(obs::IMU_WZ, reading.angularVelocity.z());
  writer_.write(imu);
}

}  // namespace

std::unique_ptr<Recording> makeRawlogRecording(const std::filesystem::path& file, const SequenceCamera& camera) {
  return std::make_unique<RawlogRecording>(file, camera);
}

}  // namespace wardslam::synth
