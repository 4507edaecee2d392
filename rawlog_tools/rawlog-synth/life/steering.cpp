#include "life/steering.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

constexpr double kWallDistance_m = 0.22;  ///< A body's middle from walls, off its own straight line.
constexpr double kPersonalSpace_m = 0.3;
constexpr double kSees_m = 4.0;

double pivotOf(const SocietyWorld& world, const Member& member) {
  if (member.holds == kNobody || world.portables[member.holds].carried) return 0.0;
  const Portable& portable = world.portables[member.holds];
  return portable.pivotX_m - portable.holderX_m;
}

/// A candidate for the next tick.
struct Candidate {
  double speed_mps = 0.0;
  double turn_radps = 0.0;
};

BodyState moved(const BodyState& body, double pivot_m, const Candidate& move, double seconds) {
  BodyState next = body;
  const Vector2d pivot = body.p_m + pivot_m * directionOf(body.heading_rad);
  next.heading_rad += move.turn_radps * std::min(seconds, 0.4);
  const double middle = body.heading_rad + 0.5 * (next.heading_rad - body.heading_rad);
  next.p_m = pivot + move.speed_mps * seconds * directionOf(middle) - pivot_m * directionOf(next.heading_rad);
  return next;
}

/// How far the discs keep from the camera, counted as if they were bodies.
double cameraGap_m(const std::vector<Disc>& discs, const Vector2d& camera_m) {
  double gap_m = std::numeric_limits<double>::infinity();
  for (const Disc& disc : discs) gap_m = std::min(gap_m, (disc.p_m - camera_m).norm() - disc.radius_m + kBodyRadius_m);
  return gap_m;
}

double wallGap_m(const SocietyWorld& world, const std::vector<Disc>& discs) {
  double gap_m = ClearanceMap::kFar_m;
  for (const Disc& disc : discs) gap_m = std::min(gap_m, world.walls.at(disc.p_m) - disc.radius_m + kBodyRadius_m);
  return gap_m;
}

/// To the discs that matter, each moved on by `seconds`.
double peopleGap_m(const std::vector<Disc>& discs, const std::vector<Disc>& others, double seconds) {
  double gap_m = std::numeric_limits<double>::infinity();
  for (const Disc& other : others) {
    const Vector2d there = other.p_m + seconds * other.v_mps;
    for (const Disc& disc : discs) gap_m = std::min(gap_m, (disc.p_m - there).norm() - disc.radius_m - other.radius_m);
  }
  return gap_m;
}

std::vector<Disc> othersNear(const Surroundings& around, std::size_t who, const Vector2d& p_m) {
  std::vector<Disc> others;
  for (std::size_t i = 0; i < around.discs.size(); ++i) {
    if (i == who) continue;
    for (const Disc& disc : around.discs[i]) {
      if ((disc.p_m - p_m).squaredNorm() < kSees_m * kSees_m) others.push_back(disc);
    }
  }
  return others;
}

double distanceToLeg_m(const Heading& heading, const Vector2d& p_m) {
  const Vector2d leg = heading.target_m - heading.leg_m;
  const double length2 = std::max(1e-9, leg.squaredNorm());
  const double s = std::clamp((p_m - heading.leg_m).dot(leg) / length2, 0.0, 1.0);
  return (heading.leg_m + s * leg - p_m).norm();
}

class Judge {
 public:
  Judge(const SocietyWorld& world, const Surroundings& around, std::size_t who, const Member& member,
        const Heading& heading)
      : world_(world),
        around_(around),
        member_(member),
        heading_(heading),
        pivot_m_(pivotOf(world, member)),
        patience_(1 / (1 + member.stuck_s)),
        others_(othersNear(around, who, member.body.p_m)) {
    const std::vector<Disc> now = discsOf(world, member, member.body);
    camera_m_ = cameraGap_m(now, around.camera_m[0]);
    wall_m_ = wallGap_m(world, now);
    people_m_ = peopleGap_m(now, others_, kTick_s);
  }

  [[nodiscard]] bool isAllowed(const BodyState& next) const {
    const std::vector<Disc> discs = discsOf(world_, member_, next);
    const double camera_m = cameraGap_m(discs, around_.camera_m[0]);
    if (camera_m < kCameraDistance_m && camera_m < camera_m_ + 1e-9) return false;
    const double wall_m = wallGap_m(world_, discs);
    // Along its own straight line somebody gets closer to things: that line is free.
    const bool onLine = member_.holds == kNobody && wall_m > (heading_.narrow ? 0.03 : 0.15) &&
                        distanceToLeg_m(heading_, next.p_m) < 0.06;
    if (!onLine && wall_m < kWallDistance_m && wall_m < wall_m_ + 1e-9) return false;
    // Nor through one: what is farther from it may lie behind it.
    if (world_.walls.along(member_.body.p_m, next.p_m) < std::min(0.03, wall_m_ - 0.01)) return false;
    const double people_m = peopleGap_m(discs, others_, kTick_s);
    return people_m > -0.08 - 0.06 * std::max(0.0, member_.stuck_s - 3) ||
           people_m > people_m_;  // who waits long squeezes past
  }

  [[nodiscard]] double cost(const Candidate& move) const {
    const BodyState soon = moved(member_.body, pivot_m_, move, 0.5);
    const Vector2d pivot = soon.p_m + pivot_m_ * directionOf(soon.heading_rad);
    const Vector2d to = heading_.target_m - pivot;
    double cost = 1.2 * (1 - move.speed_mps / std::max(0.1, heading_.speed_mps)) + 0.05 * std::abs(move.turn_radps);
    if (to.norm() > 0.15) cost += std::abs(std::remainder(std::atan2(to.y(), to.x()) - soon.heading_rad, 2 * M_PI));
    for (std::size_t i = 1; i < Surroundings::kLater_s.size(); ++i) {
      const double later_s = Surroundings::kLater_s[i];
      const std::vector<Disc> discs = discsOf(world_, member_, moved(member_.body, pivot_m_, move, later_s));
      const double camera_m = cameraGap_m(discs, around_.camera_m[i]);
      cost += 5 * std::max(0.0, kCameraDistance_m + 0.3 - camera_m) / (0.5 + later_s);
      const double people_m = peopleGap_m(discs, others_, later_s);
      cost += 3 * patience_ * std::max(0.0, kPersonalSpace_m * patience_ - people_m) / (0.5 + later_s);
      if (i < 4) cost += 3 * std::max(0.0, kWallDistance_m + 0.08 - wallGap_m(world_, discs)) / (0.5 + later_s);
    }
    return cost;
  }

  [[nodiscard]] double pivot_m() const { return pivot_m_; }
  [[nodiscard]] const std::vector<Disc>& others() const { return others_; }

 private:
  const SocietyWorld& world_;
  const Surroundings& around_;
  const Member& member_;
  const Heading& heading_;
  double pivot_m_;
  double patience_;  ///< 1 … 0: how much one cares for others' space.
  std::vector<Disc> others_;
  double camera_m_ = 0.0;
  double wall_m_ = 0.0;
  double people_m_ = 0.0;
};

}  // namespace

std::vector<Disc> discsOf(const Portable& portable, const ThingState& state) {
  const double radius_m = portable.width_m / 2;
  const double length_m = portable.to_m - portable.from_m;
  const int count = std::max(1, static_cast<int>(std::ceil(length_m / portable.width_m - 0.2)));
  std::vector<Disc> discs;
  for (int i = 0; i < count; ++i) {
    const double x = count == 1 ? (portable.from_m + portable.to_m) / 2
                                : portable.from_m + radius_m + (length_m - 2 * radius_m) * i / (count - 1);
    discs.push_back({state.p_m + x * directionOf(state.heading_rad), Vector2d::Zero(), radius_m});
  }
  return discs;
}

std::vector<Disc> discsOf(const SocietyWorld& world, const Member& member, const BodyState& body) {
  const Vector2d v = member.speed_mps * directionOf(body.heading_rad);
  std::vector<Disc> discs;
  if (member.holds != kNobody) {
    const Portable& portable = world.portables[member.holds];
    const double yaw = body.heading_rad - portable.holderHeading_rad;
    discs = discsOf(portable, {body.p_m - portable.holderX_m * directionOf(yaw), yaw, 0.0});
    for (Disc& disc : discs) disc.v_mps = v;
  }
  discs.push_back({body.p_m, v, kBodyRadius_m});
  return discs;
}

Surroundings lookAround(const SocietyWorld& world, const SocietyState& state, double t_s) {
  Surroundings around;
  for (std::size_t i = 0; i < around.camera_m.size(); ++i)
    around.camera_m[i] = world.camera_m(t_s + Surroundings::kLater_s[i]);
  for (const Member& member : state.members) {
    around.discs.push_back(member.sitsIn == kNobody ? discsOf(world, member, member.body) : std::vector<Disc>());
  }
  for (std::size_t i = 0; i < state.things.size(); ++i) {
    around.discs.push_back(state.heldBy[i] == kNobody ? discsOf(world.portables[i], state.things[i])
                                                      : std::vector<Disc>());
  }
  return around;
}

BodyState steer(const SocietyWorld& world, const Surroundings& around, std::size_t who, const Member& member,
                const Heading& heading) {
  const Judge judge(world, around, who, member, heading);
  const Vector2d pivot = member.body.p_m + judge.pivot_m() * directionOf(member.body.heading_rad);
  const Vector2d to = heading.target_m - pivot;
  const double error = std::remainder(std::atan2(to.y(), to.x()) - member.body.heading_rad, 2 * M_PI);
  const double most_radps = judge.pivot_m() > 0 ? 0.8 : 3.0;
  const double wanted_radps = std::clamp(error / 0.35, -most_radps, most_radps);
  const double fastest =
      std::min(member.speed_mps + 0.25, heading.speed_mps) * std::clamp(1.3 * std::cos(error), 0.0, 1.0);
  BodyState best = member.body;
  double least = judge.cost({0.0, 0.0});
  for (const double part : {1.0, 0.65, 0.3, 0.0}) {
    for (const double aside : {0.0, -0.8, 0.8, -1.6, 1.6, -2.6, 2.6}) {
      const Candidate move{part * fastest, std::clamp(wanted_radps + aside, -most_radps, most_radps)};
      const BodyState next = moved(member.body, judge.pivot_m(), move, kTick_s);
      if (!judge.isAllowed(next)) continue;
      const double cost = judge.cost(move);
      if (cost >= least) continue;
      least = cost;
      best = next;
    }
  }
  return best;
}

double cameraDistance_m(const Surroundings& around, const std::vector<Disc>& discs) {
  return cameraGap_m(discs, around.camera_m[0]);
}

bool isInCamerasWay(const Surroundings& around, const std::vector<Disc>& discs) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (cameraGap_m(discs, around.camera_m[i]) < kCameraDistance_m + 0.05) return true;
  }
  return false;
}

BodyState stepAside(const SocietyWorld& world, const Surroundings& around, std::size_t who, const Member& member) {
  const std::vector<Disc> others = othersNear(around, who, member.body.p_m);
  const double wallNow_m = wallGap_m(world, discsOf(world, member, member.body));
  BodyState best = member.body;
  double most = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 48; ++i) {
    const double speed = i == 0 ? 0.0 : kFastest_mps * (1 + (i - 1) / 16) / 3.0;
    BodyState next = member.body;
    const Vector2d v = speed * directionOf(2 * M_PI * i / 16);
    next.p_m += kTick_s * v;
    const double wall_m = wallGap_m(world, discsOf(world, member, next));
    if (wall_m < kWallDistance_m - 0.02 && wall_m < wallNow_m + 1e-9 && i > 0) continue;
    if (i > 0 && world.walls.along(member.body.p_m, next.p_m) < 0.03) continue;
    double value = -0.3 * speed;
    for (std::size_t k = 0; k < 5; ++k) {
      BodyState later = member.body;
      later.p_m += std::min(0.8, Surroundings::kLater_s[k]) * v;
      const std::vector<Disc> discs = discsOf(world, member, later);
      const double gap_m = cameraGap_m(discs, around.camera_m[k]);
      value += (k == 0 ? 40 : 8) * std::min(0.0, gap_m - kCameraDistance_m - 0.08);
      value += std::min(0.0, peopleGap_m(discs, others, Surroundings::kLater_s[k])) * 2;
      value += 6 * std::min(0.0, wallGap_m(world, discs) - kWallDistance_m);
    }
    if (value <= most) continue;
    most = value;
    best = next;
  }
  return best;
}

}  // namespace wardslam::synth
