#include "wardslam/navigation/obstacles.h"

#include <mrpt/maps/CSimplePointsMap.h>

#include <opencv2/core.hpp>
#include <utility>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/depth_points.h"

namespace wardslam::navigation {
namespace {

constexpr float kStandingHeight_m = 0.5F;  ///< The plan has no heights; any a robot would hit will do.

bool isOccupied(const cv::Mat& cells, int row, int column) {
  return cells.at<unsigned char>(row, column) == mapping::FloorPlan::kOccupied;
}

/// Whether it has an occupied cell on every side: the inside of a thing, which nobody reaches.
bool isInside(const cv::Mat& cells, int row, int column) {
  return row > 0 && column > 0 && row + 1 < cells.rows && column + 1 < cells.cols &&
         isOccupied(cells, row - 1, column) && isOccupied(cells, row + 1, column) &&
         isOccupied(cells, row, column - 1) && isOccupied(cells, row, column + 1);
}

std::vector<Eigen::Vector3f> outlineOf(const mapping::FloorPlan& plan) {
  std::vector<Eigen::Vector3f> points_m;
  for (int row = 0; row < plan.cells.rows; ++row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      if (!isOccupied(plan.cells, row, column) || isInside(plan.cells, row, column)) continue;
      const Eigen::Vector2d centre_m = plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      points_m.emplace_back(static_cast<float>(centre_m.x()), static_cast<float>(centre_m.y()), kStandingHeight_m);
    }
  }
  return points_m;
}

/// What a frame shows between the heights over the ground, in a frame "to"; so is the ground.
std::vector<Eigen::Vector3f> pointsOf(const core::Frame& frame, const Eigen::Isometry3d& T_to_cam,
                                      const core::GroundPlane& ground, const ObstacleOptions& options) {
  std::vector<Eigen::Vector3f> points_m;
  for (const auto& point : mapping::depthPoints(frame.depth_m, frame.camera, options.pixel_step)) {
    if (point.p_cam_m.z() > options.max_depth_m) continue;
    const bool mayMove = !frame.mayMove.empty() && frame.mayMove.at<std::uint8_t>(point.raw_px) != 0;
    if (options.only_moving && !mayMove) continue;
    const Eigen::Vector3d p_to_m = T_to_cam * point.p_cam_m;
    const double height_m = ground.heightOf_m(p_to_m);
    if (height_m < options.min_height_m || height_m > options.max_height_m) continue;
    points_m.emplace_back(p_to_m.cast<float>());
  }
  return points_m;
}

}  // namespace

Obstacles::Obstacles(const mapping::FloorPlan& plan, const ObstacleOptions& options)
    : options_(options), standing_map_m_(outlineOf(plan)) {}

void Obstacles::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  const core::GroundPlane zero = core::GroundPlane::atZero(Eigen::Isometry3d::Identity());
  if (odometry.hasPose()) {
    if (odometry.keyframe && odometry.keyframe->ground) {
      ground_map_ = odometry.keyframe->ground->seenFrom(odometry.T_map_cam);
    }
    return see(pointsOf(frame, odometry.T_map_cam, ground_map_.value_or(zero), options_), frame.stamp_s);
  }
  auto p_base_m = pointsOf(frame, frame.T_base_cam, zero, options_);
  const std::lock_guard lock(mutex_);
  seen_map_m_.clear();
  seen_base_m_ = std::move(p_base_m);
  stamp_s_ = frame.stamp_s;
}

void Obstacles::see(std::vector<Eigen::Vector3f> p_map_m, double stamp_s) {
  const std::lock_guard lock(mutex_);
  seen_map_m_ = std::move(p_map_m);
  seen_base_m_.clear();
  stamp_s_ = stamp_s;
}

SensedObstacles Obstacles::sense(const Eigen::Isometry3d& T_map_base) const {
  const Eigen::Isometry3f T_base_map = T_map_base.inverse().cast<float>();
  const Eigen::Vector2f here_m = T_map_base.translation().head<2>().cast<float>();
  const auto radius_m = static_cast<float>(options_.radius_m);
  SensedObstacles sensed;
  for (const auto& p_map_m : standing_map_m_) {
    if ((p_map_m.head<2>() - here_m).norm() <= radius_m) sensed.p_base_m.emplace_back(T_base_map * p_map_m);
  }
  const std::lock_guard lock(mutex_);
  for (const auto& p_map_m : seen_map_m_) sensed.p_base_m.emplace_back(T_base_map * p_map_m);
  sensed.p_base_m.insert(sensed.p_base_m.end(), seen_base_m_.begin(), seen_base_m_.end());
  sensed.stamp_s = stamp_s_;
  return sensed;
}

void fill(const SensedObstacles& sensed, mrpt::maps::CSimplePointsMap& points, mrpt::Clock::time_point& stamp) {
  points.clear();
  points.reserve(sensed.p_base_m.size());
  for (const auto& p_m : sensed.p_base_m) points.insertPointFast(p_m.x(), p_m.y(), p_m.z());
  points.mark_as_modified();
  stamp = core::toMrptTime(sensed.stamp_s);
}

}  // namespace wardslam::navigation
