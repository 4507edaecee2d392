#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "sensors/motion_sensors.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// One recorded frame with all that is known about it.
struct SequenceFrame {
  double stamp_s = 0.0;  ///< UNIX time in whole microseconds.
  cv::Mat color_bgr;     ///< CV_8UC3
  cv::Mat depth_m;       ///< CV_32FC1, as measured; 0 = none. Of an RGB-D camera,
  cv::Mat right_bgr;     ///< CV_8UC3; or this, of a stereo camera.
  cv::Mat instanceIds;   ///< CV_16UC1
  cv::Mat dynamic;       ///< CV_8UC1, 255 where something truly moves at that moment.
  Eigen::Isometry3d T_world_cam = Eigen::Isometry3d::Identity();
};

/// What recorded the sequence: an RGB-D camera or, with a baseline, a rectified stereo camera.
struct SequenceCamera {
  core::CameraModel model;
  std::optional<double> stereoBaseline_m;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();  ///< x forward, y left, z up.
  double rate_hz = 30.0;
};

using Bytes = std::vector<std::uint8_t>;

/// What a robot would have written; each implementation is a format. It is complete or absent: commit() gives it its
/// name, without nothing is left. Errors of the disk are core::InputErrors.
class Recording {
 public:
  virtual ~Recording() = default;
  Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// The files' content or the objects of a frame; any number of threads may ask at once.
  [[nodiscard]] virtual std::vector<Bytes> encode(const SequenceFrame& frame) const = 0;
  /// In order of time, `parts` as encoded; stamps are UNIX s.
  virtual void writeFrame(double stamp_s, const std::vector<Bytes>& parts) = 0;
  virtual void writeOdometry(double stamp_s, const OdometryReading& reading) = 0;
  virtual void writeImu(double stamp_s, const ImuReading& reading) = 0;
  virtual void commit() = 0;
};

/// FILE.rawlog: CObservation3DRangeScan or CObservationStereoImages, CObservationOdometry and CObservationIMU (which
/// sits in the camera); gzip.
[[nodiscard]] std::unique_ptr<Recording> makeRawlogRecording(const std::filesystem::path& file,
                                                             const SequenceCamera& camera);

/// A folder as in the TUM RGB-D benchmark: rgb/, depth/ (16 bits, 5000 per metre), rgb.txt, depth.txt and
/// associations.txt; camera.yaml; odometry.txt (stamp x y heading) and imu.txt (stamp, rad/s, m/s²) where there are
/// any. The folder must not be there yet, or be empty.
[[nodiscard]] std::unique_ptr<Recording> makeTumRecording(const std::filesystem::path& folder,
                                                          const SequenceCamera& camera);

}  // namespace wardslam::synth
