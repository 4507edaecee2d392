#include "built_in_room.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::apps {
namespace {

constexpr double kPixel_m = 0.01;  // of the walls
constexpr int kBlotch_px = 3;
constexpr int kWall_px = 600;
constexpr double kUnits_per_m = 5000.0;
constexpr double kRate_hz = 30.0;
const Eigen::Vector3d kMin_m(-2.0, -1.5, -1.5);
const Eigen::Vector3d kMax_m(2.0, 1.5, 3.5);

core::CameraModel camera() {
  core::CameraModel camera;
  camera.width_px = 320;
  camera.height_px = 240;
  camera.fx_px = camera.fy_px = 262.5;
  camera.cx_px = 159.5;
  camera.cy_px = 119.5;
  return camera;
}

cv::Mat blotchedWall(std::uint64_t seed) {
  cv::Mat blotches(kWall_px / kBlotch_px, kWall_px / kBlotch_px, CV_8UC1);
  cv::RNG(seed).fill(blotches, cv::RNG::UNIFORM, 0, 255);
  cv::Mat wall;
  cv::resize(blotches, wall, {kWall_px, kWall_px}, 0, 0, cv::INTER_CUBIC);
  return wall;
}

}  // namespace

BuiltInRoom::BuiltInRoom() : walls_{blotchedWall(1), blotchedWall(2), blotchedWall(3)} {}

double BuiltInRoom::stamp_s(int image) { return 1000.0 + image / kRate_hz; }

Eigen::Isometry3d BuiltInRoom::T_room_cam(int image) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = image * Eigen::Vector3d(0.008, -0.002, 0.006);
  T.linear() = Eigen::AngleAxisd(image * M_PI / 360, Eigen::Vector3d(0.2, 1.0, 0.1).normalized()).matrix();
  return T;
}

BuiltInRoom::Hit BuiltInRoom::follow(const Eigen::Isometry3d& T_room_cam, const Eigen::Vector3d& ray_cam) const {
  const Eigen::Vector3d ray = T_room_cam.linear() * ray_cam;
  const Eigen::Array3d wall_m = (ray.array() > 0).select(kMax_m, kMin_m);
  Eigen::Index axis = 0;
  const double depth_m = ((wall_m - T_room_cam.translation().array()) / ray.array()).minCoeff(&axis);
  const Eigen::Vector3d p_m = T_room_cam.translation() + depth_m * ray - kMin_m;
  const auto pixelAt = [&p_m](Eigen::Index across) {
    return std::clamp(static_cast<int>(p_m[across] / kPixel_m), 0, kWall_px - 1);
  };
  const cv::Mat& wall = walls_[static_cast<std::size_t>(axis)];
  return {depth_m, wall.at<std::uint8_t>(pixelAt((axis + 1) % 3), pixelAt((axis + 2) % 3))};
}

std::shared_ptr<mrpt::obs::CObservation3DRangeScan> BuiltInRoom::look(int image) const {
  const core::CameraModel model = camera();
  const Eigen::Isometry3d T = T_room_cam(image);
  auto scan = mrpt::obs::CObservation3DRangeScan::Create();
  scan->sensorLabel = "built_in_room";
  scan->timestamp = core::toMrptTime(stamp_s(image));
  scan->cameraParams = scan->cameraParamsIntensity = core::toMrpt(model);
  scan->hasIntensityImage = scan->hasRangeImage = scan->range_is_depth = true;
  scan->rangeUnits = static_cast<float>(1.0 / kUnits_per_m);
  scan->rangeImage_setSize(model.height_px, model.width_px);
  cv::Mat color(model.height_px, model.width_px, CV_8UC3);
  for (int y = 0; y < color.rows; ++y) {
    for (int x = 0; x < color.cols; ++x) {
      const Hit hit = follow(T, model.unproject({x, y}, 1.0));
      color.at<cv::Vec3b>(y, x) = cv::Vec3b::all(hit.grey);
      scan->rangeImage(y, x) = static_cast<std::uint16_t>(std::lround(hit.depth_m * kUnits_per_m));
    }
  }
  scan->intensityImage = mrpt::img::CImage(color, mrpt::img::DEEP_COPY);
  return scan;
}

}  // namespace wardslam::apps
