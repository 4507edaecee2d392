#include "wardslam/query/drivable_floor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <tuple>

namespace wardslam::query {
namespace {

constexpr double kAboutAsNear_m = 0.1;

Eigen::Vector2d centreOf(const mapping::FloorPlan& plan, int row, int column) {
  return plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
}

/// A cell's corners are half a diagonal from its centre.
void close(mapping::FloorPlan& plan, const mapping::Zone& zone) {
  const double halfDiagonal_m = plan.resolution_m * std::sqrt(0.5);
  for (int row = 0; row < plan.cells.rows; ++row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      auto& cell = plan.cells.at<unsigned char>(row, column);
      if (mapping::distance_m(zone, centreOf(plan, row, column)) <= halfDiagonal_m)
        cell = mapping::FloorPlan::kOccupied;
    }
  }
}

/// Distances from the middle of each cell to the edge of the nearest that is not open; what lies outside is not.
cv::Mat roomOf_m(const mapping::FloorPlan& plan, bool unknownIsFree) {
  if (plan.cells.empty()) return {};
  cv::Mat open = plan.cells == mapping::FloorPlan::kFree;
  if (unknownIsFree) open |= plan.cells == mapping::FloorPlan::kUnknown;
  cv::copyMakeBorder(open, open, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat cells;
  cv::distanceTransform(open, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat inner = cells(cv::Rect(1, 1, plan.cells.cols, plan.cells.rows));
  return (inner - 0.5) * plan.resolution_m;
}

/// The point of an upright box's outline on the floor that is nearest to a point; the point itself within it.
Eigen::Vector2d nearestOfFootprint(const mapping::OrientedBox& box, const Eigen::Vector2d& p_map_m) {
  const Eigen::Vector3d p_map(p_map_m.x(), p_map_m.y(), box.T_map_box.translation().z());
  const Eigen::Vector3d half = box.size_m / 2.0;
  const Eigen::Vector3d p_box = box.T_map_box.inverse() * p_map;
  return (box.T_map_box * Eigen::Vector3d(p_box.cwiseMax(-half).cwiseMin(half))).head<2>();
}

}  // namespace

mapping::FloorPlan closeZones(const mapping::FloorPlan& plan, const std::vector<mapping::Zone>& zones) {
  mapping::FloorPlan closed{plan.cells.clone(), plan.resolution_m, plan.origin_m};
  for (const auto& zone : zones) close(closed, zone);
  return closed;
}

DrivableFloor::DrivableFloor(const mapping::FloorPlan& plan, const DrivingRules& rules)
    : plan_(closeZones(plan, rules.forbidden)), radius_m_(rules.radius_m) {
  room_m_ = roomOf_m(plan_, rules.unknownIsFree);
  if (room_m_.empty()) return;
  constexpr double kRounding_m = 1e-6;
  const cv::Mat free = room_m_ >= rules.radius_m - kRounding_m;
  plan_.cells.setTo(mapping::FloorPlan::kOccupied);
  plan_.cells.setTo(mapping::FloorPlan::kFree, free);
  cv::connectedComponents(free, part_);
}

cv::Point DrivableFloor::cellAt(const Eigen::Vector2d& p_map_m) const {
  const Eigen::Vector2d cell = ((p_map_m - plan_.origin_m) / plan_.resolution_m).array().floor();
  return {static_cast<int>(cell.x()), static_cast<int>(cell.y())};
}

Eigen::Vector2d DrivableFloor::centre_m(const cv::Point& cell) const { return centreOf(plan_, cell.y, cell.x); }

std::optional<Eigen::Vector2d> DrivableFloor::nearestFree(const Eigen::Vector2d& p_map_m, double reach_m) const {
  const cv::Rect inside({0, 0}, part_.size());
  const cv::Point here = cellAt(p_map_m);
  if (inside.contains(here) && part_.at<int>(here) != 0) return p_map_m;
  const int reach = static_cast<int>(std::ceil(reach_m / plan_.resolution_m));
  const cv::Rect window = cv::Rect(here.x - reach, here.y - reach, 2 * reach + 1, 2 * reach + 1) & inside;
  std::optional<Eigen::Vector2d> nearest;
  double distance_m = reach_m;
  for (int y = window.y; y < window.br().y; ++y) {
    for (int x = window.x; x < window.br().x; ++x) {
      const double off_m = (centre_m({x, y}) - p_map_m).norm();
      if (part_.at<int>(y, x) == 0 || off_m > distance_m) continue;
      distance_m = off_m;
      nearest = centre_m({x, y});
    }
  }
  return nearest;
}

std::optional<Spot> DrivableFloor::spotBeside(const mapping::MapObject& object, double reach_m,
                                              const std::optional<Eigen::Vector2d>& from_map_m) const {
  int wantedPart = 0;  // any
  if (from_map_m) {
    const auto from = nearestFree(*from_map_m, radius_m_);
    if (!from) return std::nullopt;
    wantedPart = part_.at<int>(cellAt(*from));
  }
  std::optional<Spot> best;
  std::tuple<int, float> bestRank;  // how near, then how little room
  for (int row = 0; row < part_.rows; ++row) {
    for (int column = 0; column < part_.cols; ++column) {
      const int part = part_.at<int>(row, column);
      if (part == 0 || (wantedPart != 0 && part != wantedPart)) continue;
      const Eigen::Vector2d p = centreOf(plan_, row, column);
      const Eigen::Vector2d toObject = nearestOfFootprint(object.orientedBox, p) - p;
      const double gap_m = toObject.norm() - radius_m_;
      if (gap_m < 0.0 || gap_m > reach_m) continue;
      const std::tuple rank(static_cast<int>(gap_m / kAboutAsNear_m), -room_m_.at<float>(row, column));
      if (best && rank >= bestRank) continue;
      bestRank = rank;
      best = Spot{p, std::atan2(toObject.y(), toObject.x())};
    }
  }
  return best;
}

}  // namespace wardslam::query
