#include "known_ground.h"

#include <cmath>
#include <limits>

#include "ground_slope.h"

namespace wardslam::mapping {
namespace {

constexpr double kMaxTilt_rad = 10.0 * M_PI / 180.0;  // a ramp, and what the pose is off by
constexpr double kHeightTolerance_m = 0.06;           // and as a ramp rises on the way
constexpr double kLookout_m = 5.0;                    // beyond, the ground's height is a guess

}  // namespace

std::optional<KnownGround> groundKnownAt(const std::map<odometry::KeyframeId, PlacedKeyframe>& keyframes,
                                         const PlacedKeyframe& here) {
  const PlacedKeyframe* nearest = nullptr;
  double distance_m = std::numeric_limits<double>::infinity();
  for (const auto& [id, keyframe] : keyframes) {
    if (keyframe.piece != here.piece || !keyframe.ground) continue;
    const double off_m = (keyframe.T_map_cam.translation() - here.T_map_cam.translation()).norm();
    if (off_m >= distance_m) continue;
    nearest = &keyframe;
    distance_m = off_m;
  }
  if (nearest == nullptr) return std::nullopt;
  return KnownGround{nearest->ground->seenFrom(here.T_map_cam.inverse() * nearest->T_map_cam), distance_m};
}

GroundExpectation expectedAt(const PlacedKeyframe& here, const std::optional<KnownGround>& known) {
  GroundExpectation expected;
  if (!known) {
    expected.up_cam = here.T_map_cam.linear().transpose() * Eigen::Vector3d::UnitZ();
    return expected;
  }
  expected.up_cam = known->plane.normal_cam;
  expected.maxTilt_rad = kMaxTilt_rad;
  if (known->distance_m > kLookout_m) return expected;
  expected.height_m = known->plane.height_m;
  expected.heightTolerance_m = kHeightTolerance_m + kSteepest * known->distance_m;
  return expected;
}

StandingGround lookAtGround(const View& view, const std::map<odometry::KeyframeId, PlacedKeyframe>& keyframes,
                            PlacedKeyframe& here) {
  const auto known = groundKnownAt(keyframes, here);
  if (!here.ground) here.ground = findGround(view.depth_m, view.camera, expectedAt(here, known));
  if (here.ground) return {*here.ground, true};
  if (known) return {known->plane, true};
  return {core::GroundPlane::atZero(here.T_map_cam), false};
}

FloorSeen floorSeenBy(const std::map<odometry::KeyframeId, PlacedKeyframe>& keyframes,
                      std::optional<std::uint32_t> piece) {
  FloorSeen floor;
  Eigen::Vector3d up_map = Eigen::Vector3d::Zero();
  for (const auto& [id, keyframe] : keyframes) {
    if (piece != keyframe.piece) continue;
    ++floor.keyframes;
    if (!keyframe.ground) continue;
    ++floor.seen;
    up_map += keyframe.T_map_cam.linear() * keyframe.ground->normal_cam;
  }
  if (floor.seen > 0) floor.tilt_rad = std::atan2(up_map.head<2>().norm(), up_map.z());
  return floor;
}

}  // namespace wardslam::mapping
