#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "people/figure.h"

/// What a society of people and the things they move are at one time; plain values that can be kept and compared.
namespace wardslam::synth {

constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

/// Somebody's place and posture. x to the front.
struct BodyState {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;  ///< Continuous, not wrapped.
  FigurePose pose;

  [[nodiscard]] bool operator==(const BodyState& other) const {
    return p_m == other.p_m && heading_rad == other.heading_rad && pose == other.pose;
  }
};

/// Where a thing's model is.
struct ThingState {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  double z_m = 0.0;

  [[nodiscard]] bool operator==(const ThingState& other) const {
    return p_m == other.p_m && heading_rad == other.heading_rad && z_m == other.z_m;
  }
};

/// One thing to do; an errand is a few of them in turn.
struct Step {
  enum class Kind {
    Walk,     ///< Along `path_m`.
    Face,     ///< Turn on the spot to `heading_rad`.
    Wait,     ///< For `seconds`; with `talks`, speaking at times.
    SitDown,  ///< Back onto a seat `seat_m` high, kSeatedFeet_m behind.
    GetUp,
    Grip,     ///< Take hold of thing `index`.
    Release,  ///< And let go of it.
    Escort,   ///< Keep the company of the camera for `seconds`, at place `index` around it.
    Free      ///< Give back place `index`.
  };
  Kind kind = Kind::Wait;
  std::vector<Eigen::Vector2d> path_m = {};
  bool exact = true;  ///< Walk: end at the last point and nowhere beside it.
  double heading_rad = 0.0;
  double seconds = 0.0;
  double seat_m = 0.0;
  std::size_t index = 0;
  bool talks = false;
};

struct Member {
  BodyState body;
  std::vector<Step> steps;                              ///< In reverse: the next one is at the back.
  std::size_t onPath = 0;                               ///< Next corner of the path being walked.
  Eigen::Vector2d legFrom_m = Eigen::Vector2d::Zero();  ///< From there to that corner the way is known to be free.
  double speed_mps = 0.0;
  double walks_mps = 1.1;  ///< Pace where nobody is in the way.
  double stride_m = 1.36;
  double done_s = 0.0;  ///< Spent on the step at the back.
  double stuck_s = 0.0;
  std::size_t holds = kNobody;   ///< A thing.
  std::size_t sitsIn = kNobody;  ///< A thing that carries this one: moves with it, does nothing else.
  std::uint64_t dice = 1;        ///< State of the own random numbers.
};

/// All that changes.
struct SocietyState {
  std::vector<Member> members;
  std::vector<ThingState> things;
  std::vector<std::size_t> heldBy;      ///< By thing.
  std::vector<std::size_t> placeTaken;  ///< By whom, by place of the world.
  std::uint64_t tick = 0;
};

/// What is seen of it.
struct Snapshot {
  std::vector<BodyState> bodies;
  std::vector<ThingState> things;
};

}  // namespace wardslam::synth
