#include "floor_without_things.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace wardslam::building {
namespace {

constexpr double kFlat_m = 0.35;          // doors, windows, curtains and pictures are part of a wall
constexpr double kLargestIsland_m = 2.5;  // across: a table, a pillar, what nobody saw behind them
constexpr double kLargestRest_m = 0.5;    // of a thing, beside its box
constexpr double kGap_m = 0.15;           // unknown floor between two looks

cv::Point cellAt(const mapping::FloorPlan& plan, const Eigen::Vector2d& p_map_m) {
  const Eigen::Vector2d cell = (p_map_m - plan.origin_m) / plan.resolution_m - Eigen::Vector2d::Constant(0.5);
  return {static_cast<int>(std::lround(cell.x())), static_cast<int>(std::lround(cell.y()))};
}

/// Seen from above.
bool isFlat(const mapping::OrientedBox& box) {
  const Eigen::Matrix3d axes = box.T_map_box.linear();
  Eigen::Index upright = 0;
  axes.row(2).cwiseAbs().maxCoeff(&upright);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (axis != upright && box.size_m[axis] < kFlat_m) return true;
  }
  return false;
}

/// The ground it stands on.
std::vector<cv::Point> footprint(const mapping::FloorPlan& plan, const mapping::OrientedBox& box) {
  const Eigen::Vector3d half_m = box.size_m / 2.0;
  std::vector<cv::Point> corners;
  for (const double x : {-half_m.x(), half_m.x()}) {
    for (const double y : {-half_m.y(), half_m.y()}) {
      for (const double z : {-half_m.z(), half_m.z()}) {
        corners.push_back(cellAt(plan, (box.T_map_box * Eigen::Vector3d(x, y, z)).head<2>()));
      }
    }
  }
  std::vector<cv::Point> outline;
  cv::convexHull(corners, outline);
  return outline;
}

/// Their footprints and a cell around them, which is less than a wall that was seen from both sides has.
void clear(const mapping::FloorPlan& plan, const std::vector<const mapping::MapObject*>& things, cv::Mat& floor) {
  cv::Mat footprints(floor.size(), CV_8UC1, cv::Scalar(0));
  for (const auto* thing : things) {
    if (isFlat(thing->orientedBox)) continue;
    cv::fillConvexPoly(footprints, footprint(plan, thing->orientedBox), cv::Scalar(255));
  }
  cv::dilate(footprints, footprints, cv::Mat());
  floor |= footprints;
}

/// Unknown cells between free ones; walls stay.
void closeGaps(const mapping::FloorPlan& plan, cv::Mat& floor) {
  const int cells = 2 * static_cast<int>(std::lround(kGap_m / plan.resolution_m / 2.0)) + 1;
  cv::Mat closed;
  cv::morphologyEx(floor, closed, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_ELLIPSE, {cells, cells}));
  floor |= closed & (plan.cells == mapping::FloorPlan::kUnknown);
}

/// What stands alone on the floor and is at most so many cells across is no wall.
void clearIslands(double largest, cv::Mat& floor) {
  cv::Mat rest;
  cv::copyMakeBorder(floor == 0, rest, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::Mat parts;
  cv::Mat extents;
  cv::Mat centres;
  const int count = cv::connectedComponentsWithStats(rest, parts, extents, centres, 8, CV_32S);
  std::vector<unsigned char> isIsland(static_cast<std::size_t>(count), 0);
  for (int part = 1; part < count; ++part) {
    const int* extent = extents.ptr<int>(part);
    isIsland[static_cast<std::size_t>(part)] =
        std::hypot(extent[cv::CC_STAT_WIDTH], extent[cv::CC_STAT_HEIGHT]) <= largest ? 1 : 0;
  }
  for (int row = 0; row < floor.rows; ++row) {
    for (int column = 0; column < floor.cols; ++column) {
      if (isIsland[static_cast<std::size_t>(parts.at<int>(row + 1, column + 1))] != 0) {
        floor.at<unsigned char>(row, column) = 255;
      }
    }
  }
}

}  // namespace

cv::Mat seenFloor(const mapping::FloorPlan& plan) {
  cv::Mat floor = plan.cells == mapping::FloorPlan::kFree;
  closeGaps(plan, floor);
  return floor;
}

cv::Mat floorWithoutThings(const mapping::FloorPlan& plan, const std::vector<const mapping::MapObject*>& things) {
  cv::Mat floor = seenFloor(plan);
  clearIslands(kLargestIsland_m / plan.resolution_m, floor);
  // Only now: things on both sides may cut a wall to pieces that would look like islands.
  clear(plan, things, floor);
  clearIslands(kLargestRest_m / plan.resolution_m, floor);
  return floor;
}

}  // namespace wardslam::building
