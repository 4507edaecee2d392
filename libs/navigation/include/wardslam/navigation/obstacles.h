#pragma once

#include <mrpt/core/Clock.h>

#include <Eigen/Geometry>
#include <mutex>
#include <optional>
#include <vector>

#include "wardslam/core/ground_plane.h"
#include "wardslam/core/options.h"
#include "wardslam/mapping/floor_plan.h"
#include "wardslam/pipeline/frame_observer.h"

namespace mrpt::maps {
class CSimplePointsMap;
}

namespace wardslam::navigation {

struct ObstacleOptions {
  double radius_m = 4.0;
  double min_height_m = 0.1;
  double max_height_m = 1.8;
  double max_depth_m = 3.5;
  int pixel_step = 4;
  bool only_moving = false;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("radius_m", self.radius_m, {0.1, 100.0}, "m", "obstacles of the map are given up to this far");
    visit("min_height_m", self.min_height_m, {0.0, 1.0}, "m", "a robot drives over what is lower");
    visit("max_height_m", self.max_height_m, {0.1, 5.0}, "m", "and under what is higher");
    visit("max_depth_m", self.max_depth_m, {0.1, 20.0}, "m", "the camera is believed up to this far");
    visit("pixel_step", self.pixel_step, {1, 32}, "px", "every so many pixels of a row and of a column are used");
    visit("only_moving", self.only_moving,
          "of what the camera sees, only what may move; otherwise also what is new since the map was made");
  }
};

/// Obstacles in the robot frame.
struct SensedObstacles {
  std::vector<Eigen::Vector3f> p_base_m;
  double stamp_s = 0.0;  ///< UNIX time when what may move was seen; 0 = never.
};

/// What is in a robot's way: what stands there according to the map, and what was seen last. Add it to a SlamSystem as
/// observer, and answer CRobot2NavInterface::senseObstacles with it. Threads may see and sense at once.
class Obstacles : public pipeline::FrameObserver {
 public:
  /// Occupied cells of the plan are obstacles; close forbidden zones first (query::closeZones).
  explicit Obstacles(const mapping::FloorPlan& plan, const ObstacleOptions& options = {});

  /// What a frame shows takes the place of what was seen before. Of a frame without a pose it lies before the robot,
  /// wherever that is (Frame::T_base_cam, with the robot's frame on the floor), until the next frame.
  /// Heights count from the floor that the last keyframe shows, where one did; else from z = 0.
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// The same for points that another sensor sees (m, map frame).
  void see(std::vector<Eigen::Vector3f> p_map_m, double stamp_s);

  /// Of the map up to a radius around the robot, of what was seen all.
  [[nodiscard]] SensedObstacles sense(const Eigen::Isometry3d& T_map_base) const;

 private:
  ObstacleOptions options_;
  std::optional<core::GroundPlane> ground_map_;  ///< As seen from the map's origin.
  std::vector<Eigen::Vector3f> standing_map_m_;
  mutable std::mutex mutex_;  ///< Of what follows.
  std::vector<Eigen::Vector3f> seen_map_m_;
  std::vector<Eigen::Vector3f> seen_base_m_;  ///< By a frame without a pose.
  double stamp_s_ = 0.0;
};

/// As senseObstacles() wants it. Replaces what `points` held.
void fill(const SensedObstacles& sensed, mrpt::maps::CSimplePointsMap& points, mrpt::Clock::time_point& stamp);

}  // namespace wardslam::navigation
