#include "range_scanner.h"

namespace wardslam::nav_demo {

std::vector<Eigen::Vector2d> scan(const TrueWorld& world, const std::vector<Disc>& people,
                                  const Eigen::Isometry2d& T_world_robot, const ScannerOptions& options) {
  std::vector<Eigen::Vector2d> points_m;
  for (int i = 0; i < options.rays; ++i) {
    const double angle_rad = options.fieldOfView_rad * (static_cast<double>(i) / (options.rays - 1) - 0.5);
    const Eigen::Vector2d ray(std::cos(angle_rad), std::sin(angle_rad));
    const double range_m =
        world.sightFrom_m(T_world_robot.translation(), T_world_robot.linear() * ray, options.range_m, people);
    if (range_m < options.range_m) points_m.emplace_back(range_m * ray);
  }
  return points_m;
}

}  // namespace wardslam::nav_demo
