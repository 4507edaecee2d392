#include "keyframe_scans.h"

#include <mrpt/img/CImage.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/depth_points.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CObservation3DRangeScan;

/// What says where and how the scan was taken, and nothing of what it shows.
CObservation3DRangeScan::Ptr withoutContent(const CObservation3DRangeScan& scan) {
  auto bare = CObservation3DRangeScan::Create();
  bare->timestamp = scan.timestamp;
  bare->sensorLabel = scan.sensorLabel;
  bare->sensorPose = scan.sensorPose;
  bare->relativePoseIntensityWRTDepth = scan.relativePoseIntensityWRTDepth;
  bare->cameraParams = scan.cameraParams;
  bare->cameraParamsIntensity = scan.cameraParamsIntensity;
  bare->range_is_depth = scan.range_is_depth;
  bare->rangeUnits = scan.rangeUnits;
  bare->maxRange = scan.maxRange;
  bare->stdError = scan.stdError;
  return bare;
}

/// Of what does not move. Points are in the sensor's frame, whose x axis is ahead.
void addPoints(const core::Frame& frame, int step_px, CObservation3DRangeScan& scan) {
  auto points = mapping::depthPoints(frame.depth_m, frame.camera, step_px);
  if (!frame.mayMove.empty()) {
    const auto moves = [&](const mapping::DepthPoint& p) { return frame.mayMove.at<unsigned char>(p.raw_px) != 0; };
    points.erase(std::remove_if(points.begin(), points.end(), moves), points.end());
  }
  const Eigen::Isometry3d T_sensor_cam = core::fromMrpt(scan.sensorPose).inverse() * frame.T_base_cam;
  scan.hasPoints3D = true;
  scan.resizePoints3DVectors(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p_m = (T_sensor_cam * points[i].p_cam_m).cast<float>();
    scan.points3D_x[i] = p_m.x();
    scan.points3D_y[i] = p_m.y();
    scan.points3D_z[i] = p_m.z();
    scan.points3D_idxs_x[i] = static_cast<std::uint16_t>(points[i].raw_px.x);
    scan.points3D_idxs_y[i] = static_cast<std::uint16_t>(points[i].raw_px.y);
  }
}

/// The scan as one of the colour camera, whose depth is that of the frame; where something may move there is none.
void setDepth(const core::Frame& frame, CObservation3DRangeScan& scan) {
  constexpr float kUnits_m = 0.001F;
  cv::Mat units;
  frame.depth_m.convertTo(units, CV_16U, 1.0 / kUnits_m);
  if (!frame.mayMove.empty()) units.setTo(0, frame.mayMove);
  scan.hasRangeImage = true;
  scan.range_is_depth = true;
  scan.rangeUnits = kUnits_m;
  scan.cameraParams = scan.cameraParamsIntensity;
  scan.rangeImage_setSize(units.rows, units.cols);
  units.copyTo(cv::Mat(units.size(), CV_16UC1, scan.rangeImage.data()));
}

/// The same sensor, where its colour camera is.
void moveToColorCamera(const core::Frame& frame, CObservation3DRangeScan& scan) {
  scan.sensorPose = core::toMrpt(frame.T_base_cam * core::T_sensor_cam().inverse());
  scan.relativePoseIntensityWRTDepth = core::toMrpt(core::T_sensor_cam());
}

[[noreturn]] void refuse(const std::string& file) {
  throw core::InputError(file + ": the image of a keyframe cannot be written; is the disk full?");
}

}  // namespace

KeyframeScans::KeyframeScans(const MapBuilderOptions& options) : options_(options) {
  if (options_.images.empty()) return;
  std::error_code failure;
  std::filesystem::create_directories(options_.images, failure);
  if (failure) {
    throw core::InputError("images: the folder " + options_.images + " cannot be made (" + failure.message() +
                           "); give one that can, or none");
  }
  options_.images = std::filesystem::absolute(options_.images).string();
}

void KeyframeScans::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (!odometry.keyframe || !frame.observation) return;
  const auto scan = withoutContent(*frame.observation);
  if (!options_.images.empty()) moveToColorCamera(frame, *scan);
  addPoints(frame, options_.points_px, *scan);
  if (!options_.images.empty()) storeImages(frame, odometry.keyframe->id, *scan);
  auto observed = mrpt::obs::CSensoryFrame::Create();
  for (const auto& observation : observed_) {
    if (observation == frame.observation) {
      observed->insert(scan);
    } else if (!std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) {
      observed->insert(observation);
    }
  }
  scans_[odometry.keyframe->id] = {frame.T_base_cam, observed};
}

void KeyframeScans::onUpdate(const odometry::MapUpdate& update) {
  for (const auto& removed : update.removedKeyframes) scans_.erase(removed.id);
}

/// By their full names: those that are relative are looked for where a global variable of MRPT says.
void KeyframeScans::storeImages(const core::Frame& frame, odometry::KeyframeId keyframe,
                                CObservation3DRangeScan& scan) {
  const CObservation3DRangeScan& full = *frame.observation;
  if (!full.hasIntensityImage) return;
  const std::string name = options_.images + "/keyframe_" + std::to_string(keyframe);
  const std::string color = name + "_INT.png";
  if (!full.intensityImage.saveToFile(color)) refuse(color);
  scan.hasIntensityImage = true;
  scan.intensityImageChannel = full.intensityImageChannel;
  scan.intensityImage.setExternalStorage(color);
  setDepth(frame, scan);
  try {
    scan.rangeImage_convertToExternalStorage(name + "_RANGES.bin", mrpt::img::CImage::getImagesPathBase());
  } catch (const std::exception&) {
    refuse(name + "_RANGES.bin");
  }
}

}  // namespace wardslam::mrpt_slam
