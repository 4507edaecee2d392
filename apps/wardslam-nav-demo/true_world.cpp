#include "true_world.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace wardslam::nav_demo {
namespace {

/// Distance along a ray to the near side of a disc; infinity where it misses.
double toDisc_m(const Eigen::Vector2d& p_m, const Eigen::Vector2d& direction, const Disc& disc) {
  const Eigen::Vector2d to = disc.p_m - p_m;
  const double along = to.dot(direction);
  const double aside2 = to.squaredNorm() - along * along;
  const double radius2 = disc.radius_m * disc.radius_m;
  if (along <= 0.0 || aside2 > radius2) return std::numeric_limits<double>::infinity();
  return std::max(0.0, along - std::sqrt(radius2 - aside2));
}

}  // namespace

TrueWorld::TrueWorld(mapping::FloorPlan floor) : floor_(std::move(floor)) {
  const cv::Mat open = floor_.cells != mapping::FloorPlan::kOccupied;
  cv::distanceTransform(open, room_m_, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  room_m_ *= floor_.resolution_m;
}

double TrueWorld::roomAt_m(const Eigen::Vector2d& p_m) const {
  const Eigen::Array2d cell = ((p_m - floor_.origin_m) / floor_.resolution_m).array().floor();
  if ((cell < 0).any() || cell.x() >= room_m_.cols || cell.y() >= room_m_.rows) return 0.0;
  const double toMiddle_m = room_m_.at<float>(static_cast<int>(cell.y()), static_cast<int>(cell.x()));
  return std::max(0.0, toMiddle_m - floor_.resolution_m / 2);
}

double TrueWorld::sightFrom_m(const Eigen::Vector2d& p_m, const Eigen::Vector2d& direction, double range_m,
                              const std::vector<Disc>& discs) const {
  double nearest_m = range_m;
  for (const Disc& disc : discs) nearest_m = std::min(nearest_m, toDisc_m(p_m, direction, disc));
  // Steps as long as the room around says that nothing can be met (sphere tracing).
  const double shortest_m = floor_.resolution_m / 2;
  double along_m = 0.0;
  while (along_m < nearest_m) {
    const double room_m = roomAt_m(p_m + along_m * direction);
    if (room_m <= 0.0) return along_m;
    along_m += std::max(room_m, shortest_m);
  }
  return nearest_m;
}

}  // namespace wardslam::nav_demo
