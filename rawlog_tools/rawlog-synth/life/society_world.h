#pragma once

#include <functional>
#include <vector>

#include "life/clearance.h"
#include "life/society_state.h"
#include "life/way_network.h"

namespace wardslam::synth {

/// Where somebody can be for a while.
struct RestingPlace {
  enum class Kind { Spot, Seat, Group, Parking };
  Kind kind = Kind::Spot;
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();  ///< Where one stands; of a seat, in front of it.
  double heading_rad = 0.0;
  double seat_m = 0.0;
  std::size_t wayNode = 0;
};

/// A thing that is pushed or carried, in its own frame: x to the front.
struct Portable {
  double holderX_m = -0.95;        ///< Where its holder stands …
  double holderHeading_rad = 0.0;  ///< … and looks.
  double pivotX_m = 0.0;           ///< What it turns about while it is pushed.
  bool carried = false;            ///< Lifted, not pushed.
  double handleZ_m = 1.02;
  double width_m = 0.6;
  double from_m = -0.4;  ///< Its extent along x.
  double to_m = 0.4;
  std::size_t rider = kNobody;  ///< A member who sits in it, its origin below the hips.
};

/// What does not change: ways, walls, where the camera drives.
struct SocietyWorld {
  WayNetwork ways;
  ClearanceMap walls;
  ClearanceMap cameraRoute;
  std::function<Eigen::Vector2d(double t_s)> camera_m;
  std::vector<RestingPlace> places;
  std::vector<Portable> portables;
  bool escorts = false;   ///< Some keep the camera company.
  double nearCamera = 0;  ///< Share of errands that lead to where the camera soon comes.
};

constexpr double kBodyRadius_m = 0.25;
constexpr double kCameraDistance_m = 0.55;  ///< People's middles keep that far from the camera's.

/// Places to rest at: seats and spots that can be reached, groups and parking along wide ways; none on the camera's
/// way.
void findPlaces(SocietyWorld& world, const Ways& ways);

/// Halves of what is free along the edges, for what is pushed.
void measureWays(SocietyWorld& world);

/// From a node to a node and on; empty where no way is wide enough.
[[nodiscard]] std::vector<Eigen::Vector2d> pathBetween(const SocietyWorld& world, std::size_t from, std::size_t to,
                                                       double halfWidth_m);

/// The node nearest to `p_m` that can be walked to in a straight line; kNobody where there is none.
[[nodiscard]] std::size_t reachableNode(const SocietyWorld& world, const Eigen::Vector2d& p_m, double halfWidth_m);

}  // namespace wardslam::synth
