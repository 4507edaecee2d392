#pragma once

#include <array>
#include <vector>

#include "life/society_world.h"

namespace wardslam::synth {

constexpr double kTick_s = 0.1;
constexpr double kFastest_mps = 1.5;

/// A round part of somebody or something.
struct Disc {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d v_mps = Eigen::Vector2d::Zero();
  double radius_m = kBodyRadius_m;
};

/// The camera now and a little later, and everybody's discs.
struct Surroundings {
  static constexpr std::array<double, 6> kLater_s = {kTick_s, 0.4, 0.8, 1.2, 1.8, 2.5};
  std::array<Eigen::Vector2d, kLater_s.size()> camera_m;
  std::vector<std::vector<Disc>> discs;  ///< By member, then by thing; what is held belongs to its holder.
};

/// Discs of a member and of what it holds, of the size they have at `body`.
[[nodiscard]] std::vector<Disc> discsOf(const SocietyWorld& world, const Member& member, const BodyState& body);
[[nodiscard]] std::vector<Disc> discsOf(const Portable& portable, const ThingState& state);
[[nodiscard]] Surroundings lookAround(const SocietyWorld& world, const SocietyState& state, double t_s);

/// Where to, and how fast.
struct Heading {
  Eigen::Vector2d target_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d leg_m = Eigen::Vector2d::Zero();  ///< Start of the straight line that is known to be free.
  double speed_mps = 0.0;
  bool narrow = false;  ///< Along the line also close by things, as to a seat.
};

/// Where a member is a tick later, on its way and out of everybody's. Never into a wall, never nearer to the camera
/// than kCameraDistance_m where it was farther.
[[nodiscard]] BodyState steer(const SocietyWorld& world, const Surroundings& around, std::size_t who,
                              const Member& member, const Heading& heading);

/// How far discs keep from the camera a tick later, counted as if they were bodies.
[[nodiscard]] double cameraDistance_m(const Surroundings& around, const std::vector<Disc>& discs);

/// Whether the camera comes too close to somebody who stays.
[[nodiscard]] bool isInCamerasWay(const Surroundings& around, const std::vector<Disc>& discs);

/// A step out of the camera's way, looking where one looked.
[[nodiscard]] BodyState stepAside(const SocietyWorld& world, const Surroundings& around, std::size_t who,
                                  const Member& member);

[[nodiscard]] inline Eigen::Vector2d directionOf(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

/// `angle` shifted by whole turns to lie within half a turn of `reference`.
[[nodiscard]] inline double nearestTurn(double angle, double reference) {
  return reference + std::remainder(angle - reference, 2 * M_PI);
}

}  // namespace wardslam::synth
