#include "estimation_picture.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"

namespace wardslam::mrpt_slam {
namespace {

using mapping::FloorPlan;

constexpr double kMargin_m = 1.0;
const cv::Scalar kWay(0, 0, 220);
const cv::Scalar kRobot(220, 60, 0);

/// Of nothing known, around all these places.
FloorPlan unknownAround(const core::Trajectory& trajectory, const Eigen::Vector2d& robot_m) {
  FloorPlan plan;
  Eigen::AlignedBox2d around(robot_m);
  for (const auto& pose : trajectory) around.extend(Eigen::Vector2d(pose.T_map_cam.translation().head<2>()));
  plan.origin_m = around.min().array() - kMargin_m;
  const Eigen::Vector2d size = (around.sizes().array() + 2.0 * kMargin_m) / plan.resolution_m;
  plan.cells = cv::Mat(static_cast<int>(std::ceil(size.y())), static_cast<int>(std::ceil(size.x())), CV_8UC1,
                       cv::Scalar(FloorPlan::kUnknown));
  return plan;
}

cv::Point pixelOf(const FloorPlan& plan, const Eigen::Vector2d& p_map_m) {
  const Eigen::Vector2d cell = (p_map_m - plan.origin_m) / plan.resolution_m;
  return {static_cast<int>(std::floor(cell.x())), plan.cells.rows - 1 - static_cast<int>(std::floor(cell.y()))};
}

}  // namespace

cv::Mat drawEstimation(const FloorPlan& known, const core::Trajectory& trajectory,
                       const Eigen::Isometry3d& T_map_base) {
  const Eigen::Vector2d robot_m = T_map_base.translation().head<2>();
  const FloorPlan plan = known.cells.empty() ? unknownAround(trajectory, robot_m) : known;
  cv::Mat grey(plan.cells.size(), CV_8UC1, cv::Scalar(160));
  grey.setTo(255, plan.cells == FloorPlan::kFree);
  grey.setTo(0, plan.cells == FloorPlan::kOccupied);
  cv::flip(grey, grey, 0);
  cv::Mat picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);

  std::vector<cv::Point> way;
  way.reserve(trajectory.size());
  for (const auto& pose : trajectory) way.push_back(pixelOf(plan, pose.T_map_cam.translation().head<2>()));
  cv::polylines(picture, way, false, kWay);
  const Eigen::Vector2d ahead_m = robot_m + 0.4 * T_map_base.linear().col(0).head<2>();
  cv::arrowedLine(picture, pixelOf(plan, robot_m), pixelOf(plan, ahead_m), kRobot, 1, cv::LINE_8, 0, 0.4);
  cv::circle(picture, pixelOf(plan, robot_m), 2, kRobot, cv::FILLED);
  return picture;
}

void writePicture(const cv::Mat& picture, const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool isKnown = ending == ".png" || ending == ".bmp";
  std::vector<unsigned char> bytes;
  cv::imencode(isKnown ? ending : ".png", picture, bytes);
  core::writeFileAtomically(isKnown ? file : file + ".png", std::string(bytes.begin(), bytes.end()));
}

}  // namespace wardslam::mrpt_slam
