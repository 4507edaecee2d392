#include <algorithm>
#include <cmath>

#include "life/errands.h"
#include "life/society.h"
#include "life/steering.h"

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

constexpr double kTurn_radps = 2.2;
constexpr double kSit_s = 1.4;
constexpr double kReach_s = 0.5;
constexpr double kLift_s = 0.7;
constexpr double kLifted_m = 0.32;
constexpr double kArrived_m = 0.02;
constexpr double kPatience_s = 14.0;

double towards(double value, double goal, double step) {
  return value < goal ? std::min(goal, value + step) : std::max(goal, value - step);
}

double soft(double u) { return u * u * (3 - 2 * u); }

/// One tick of one member.
class Turn {
 public:
  Turn(const SocietyWorld& world, SocietyState& state, Surroundings& around, std::size_t who, double t_s)
      : world_(world), state_(state), around_(around), who_(who), member_(state.members[who]), t_s_(t_s) {}

  void take() {
    const BodyState before = member_.body;
    if (member_.steps.empty()) {
      takeErrand(world_, state_, who_, t_s_);
    }
    const bool walks = current().kind == Step::Kind::Walk || current().kind == Step::Kind::Escort;
    if (walks) proceed();
    // Who is on the way already has the camera in view; who stays, or cannot get on, makes room for it.
    const bool stays = !walks || (member_.body.p_m - before.p_m).norm() < 0.3 * kTick_s ||
                       cameraDistance_m(around_, discsOf(world_, member_, member_.body)) < kCameraDistance_m;
    if (stays && before.pose.sitting == 0 && isInCamerasWay(around_, discsOf(world_, member_, before))) {
      member_.body = before;
      member_.body = stepAside(world_, around_, who_, member_);
    } else if (!walks) {
      proceed();
    }
    swingLimbs(before);
    takeAlong();
    around_.discs[who_] = discsOf(world_, member_, member_.body);
  }

 private:
  [[nodiscard]] Step& current() { return member_.steps.back(); }

  void finish() {
    member_.steps.pop_back();
    member_.onPath = 0;
    member_.done_s = 0.0;
    member_.stuck_s = 0.0;
  }

  /// Whether something left here is out of the camera's way.
  [[nodiscard]] bool mayStay(const ThingState& thing, const Portable& portable) const {
    for (const Disc& disc : discsOf(portable, thing)) {
      if (world_.cameraRoute.at(disc.p_m) < disc.radius_m + 0.4) return false;
    }
    return true;
  }

  void giveUp() {
    const std::size_t held = member_.holds;
    member_.steps.clear();
    if (held != kNobody && mayStay(state_.things[held], world_.portables[held])) {
      Step release;
      release.kind = Step::Kind::Release;
      release.index = held;
      member_.steps.push_back(release);
    }
    member_.onPath = 0;
    member_.done_s = member_.stuck_s = 0.0;
  }

  void proceed() {
    switch (current().kind) {
      case Step::Kind::Walk:
        return walk();
      case Step::Kind::Face:
        return face();
      case Step::Kind::Wait:
        return wait();
      case Step::Kind::SitDown:
      case Step::Kind::GetUp:
        return sit();
      case Step::Kind::Grip:
        return grip();
      case Step::Kind::Release:
        return release();
      case Step::Kind::Escort:
        return escort();
      case Step::Kind::Free:
        state_.placeTaken[current().index] = kNobody;
        return finish();
    }
  }

  [[nodiscard]] Vector2d pivot() const {
    const BodyState& body = member_.body;
    if (member_.holds == kNobody || world_.portables[member_.holds].carried) return body.p_m;
    const Portable& portable = world_.portables[member_.holds];
    return body.p_m + (portable.pivotX_m - portable.holderX_m) * directionOf(body.heading_rad);
  }

  void go(const Vector2d& target_m, const Vector2d& leg_m, double speed_mps, bool narrow = false) {
    const BodyState next = steer(world_, around_, who_, member_, {target_m, leg_m, speed_mps, narrow});
    // What nobody could see is no motion.
    const bool seen =
        (next.p_m - member_.body.p_m).norm() > 1e-4 || std::abs(next.heading_rad - member_.body.heading_rad) > 1e-3;
    if (seen) member_.body = next;
  }

  void walk() {
    const Step& step = current();
    const Vector2d here = pivot();
    const bool last = member_.onPath + 1 >= step.path_m.size();
    const Vector2d goal = step.path_m[member_.onPath];
    const double left_m = (goal - here).norm();
    if (last && left_m < (step.exact ? kArrived_m : 0.25)) {
      if (step.exact) member_.body.p_m = goal;
      return finish();
    }
    if (member_.done_s == 0.0) member_.legFrom_m = here;
    member_.done_s += kTick_s;
    // Corners are cut where there is room, and met where there is none.
    const double need_m = member_.holds == kNobody ? 0.3 : world_.portables[member_.holds].width_m / 2 + 0.08;
    if (!last &&
        (left_m < 0.12 || (left_m < 6.0 && world_.walls.along(here, step.path_m[member_.onPath + 1]) > need_m))) {
      ++member_.onPath;
      member_.legFrom_m = here;
      return walk();
    }
    const Vector2d leg = member_.legFrom_m;
    const double pace = member_.holds == kNobody ? member_.walks_mps : std::min(member_.walks_mps, 0.95);
    const double speed = last && step.exact ? std::min(pace, std::max(0.12, 1.2 * left_m)) : pace;
    if (last && step.exact && left_m < 0.1) {
      arrive(goal, left_m);
    } else {
      go(aim(here, leg, goal, left_m), leg, speed, last && step.exact);
    }
    const bool stuck = (pivot() - here).norm() < 0.15 * pace * kTick_s;
    member_.stuck_s = stuck ? member_.stuck_s + kTick_s : std::max(0.0, member_.stuck_s - kTick_s);
    if (member_.stuck_s > kPatience_s) giveUp();
  }

  /// The last few centimetres, straight and whatever the heading.
  void arrive(const Vector2d& goal, double left_m) {
    const BodyState before = member_.body;
    member_.body.p_m += std::min(1.0, 0.6 * kTick_s / left_m) * (goal - before.p_m);
    if ((member_.body.p_m - around_.camera_m[0]).norm() < kCameraDistance_m) member_.body = before;
  }

  /// Ahead on the line, and to the right of it where there is room, so that people pass each other.
  [[nodiscard]] Vector2d aim(const Vector2d& here, const Vector2d& leg, const Vector2d& goal, double left_m) const {
    constexpr double kAhead_m = 0.8;
    const Vector2d line = goal - leg;
    if (left_m < kAhead_m || line.norm() < kAhead_m) return goal;
    const Vector2d along = line.normalized();
    const double s = std::min(line.norm(), std::max(0.0, (here - leg).dot(along)) + kAhead_m);
    const Vector2d ahead = leg + s * along;
    const Vector2d right(along.y(), -along.x());
    const double need_m = member_.holds == kNobody ? 0.45 : world_.portables[member_.holds].width_m / 2 + 0.2;
    for (const double aside_m : {0.4, 0.25, 0.12}) {
      if (world_.walls.at(ahead + aside_m * right) > need_m) return ahead + aside_m * right;
    }
    return ahead;
  }

  void face() {
    const double goal = nearestTurn(current().heading_rad, member_.body.heading_rad);
    member_.body.heading_rad = towards(member_.body.heading_rad, goal, kTurn_radps * kTick_s);
    if (member_.body.heading_rad == goal) finish();
  }

  void wait() {
    const Step& step = current();
    member_.done_s += kTick_s;
    FigurePose& pose = member_.body.pose;
    // Everybody of a group has the word in turn.
    const double inTurn_s = std::fmod(t_s_ + 3.7 * static_cast<double>(who_ % 5), 14.0);
    const bool speaks = step.talks && inTurn_s < 4.0 && member_.done_s < step.seconds - 1.0;
    pose.gesture = towards(pose.gesture, speaks ? 0.7 + 0.3 * std::sin(5 * inTurn_s) : 0.0, 1.5 * kTick_s);
    if (member_.done_s >= step.seconds && pose.gesture == 0.0) finish();
  }

  void sit() {
    const bool down = current().kind == Step::Kind::SitDown;
    FigurePose& pose = member_.body.pose;
    if (down) pose.seat_m = current().seat_m;
    member_.done_s = std::min(kSit_s, member_.done_s + kTick_s);
    const double u = soft(member_.done_s / kSit_s);
    const double sitting = down ? u : 1 - u;
    member_.body.p_m -= (sitting - pose.sitting) * kSeatedFeet_m * directionOf(member_.body.heading_rad);
    pose.sitting = sitting;
    if (member_.done_s == kSit_s) finish();
  }

  [[nodiscard]] bool isAtHandles(std::size_t index) const {
    const Portable& portable = world_.portables[index];
    const ThingState& thing = state_.things[index];
    const Vector2d there = thing.p_m + portable.holderX_m * directionOf(thing.heading_rad);
    return (there - member_.body.p_m).norm() < 1e-6 &&
           std::abs(std::remainder(thing.heading_rad + portable.holderHeading_rad - member_.body.heading_rad,
                                   2 * M_PI)) < 1e-6;
  }

  void hold(std::size_t index, double u) {
    const Portable& portable = world_.portables[index];
    FigurePose& pose = member_.body.pose;
    pose.reaching = soft(std::min(1.0, u * (portable.carried ? (kReach_s + kLift_s) / kReach_s : 1.0)));
    const double lifting = std::clamp((u * (kReach_s + kLift_s) - kReach_s) / kLift_s, 0.0, 1.0);
    const double z_m = portable.carried ? kLifted_m * soft(lifting) : 0.0;
    state_.things[index].z_m = z_m;
    pose.reachX_m = portable.carried ? 0.36 : anatomy::kReach_m;
    pose.reachZ_m = portable.handleZ_m + z_m;
  }

  void grip() {
    const std::size_t index = current().index;
    if (member_.holds == kNobody) {
      if (state_.heldBy[index] != kNobody || !isAtHandles(index)) return giveUp();
      state_.heldBy[index] = who_;
      member_.holds = index;
      around_.discs[state_.members.size() + index].clear();
    }
    const double whole_s = kReach_s + (world_.portables[index].carried ? kLift_s : 0.0);
    member_.done_s = std::min(whole_s, member_.done_s + kTick_s);
    hold(index, member_.done_s / whole_s);
    if (member_.done_s == whole_s) finish();
  }

  void release() {
    const std::size_t index = current().index;
    const double whole_s = kReach_s + (world_.portables[index].carried ? kLift_s : 0.0);
    member_.done_s = std::min(whole_s, member_.done_s + kTick_s);
    hold(index, 1 - member_.done_s / whole_s);
    if (member_.done_s < whole_s) return;
    state_.heldBy[index] = kNobody;
    member_.holds = kNobody;
    around_.discs[state_.members.size() + index] = discsOf(world_.portables[index], state_.things[index]);
    finish();
  }

  void escort() {
    member_.done_s += kTick_s;
    if (member_.done_s >= current().seconds) return giveUp();
    const Vector2d place = escortPlace(world_, current().index, t_s_ + kTick_s);
    const Vector2d soon = escortPlace(world_, current().index, t_s_ + 0.6);
    const double left_m = (soon - member_.body.p_m).norm();
    if ((place - member_.body.p_m).norm() < 0.15 && left_m < 0.15) return;
    go(soon, member_.body.p_m, std::min(kFastest_mps, left_m / 0.6 + 0.05));
  }

  /// Legs and arms go with the way walked.
  void swingLimbs(const BodyState& before) {
    FigurePose& pose = member_.body.pose;
    const double way_m = pose.sitting > 0 || before.pose.sitting > 0 ? 0.0 : (member_.body.p_m - before.p_m).norm();
    const double turned = std::abs(member_.body.heading_rad - before.heading_rad);
    member_.speed_mps = way_m / kTick_s;
    const double steps_m = std::max(way_m, 0.12 * turned);
    pose.stride_rad += 2 * M_PI * steps_m / member_.stride_m;
    pose.swing = towards(pose.swing, std::min(1.0, steps_m / kTick_s), 3.0 * kTick_s);
    if (pose.sitting > 0) pose.swing = 0.0;
  }

  /// What one holds comes along, exactly.
  void takeAlong() {
    if (member_.holds == kNobody) return;
    const Portable& portable = world_.portables[member_.holds];
    ThingState& thing = state_.things[member_.holds];
    const double heading = member_.body.heading_rad - portable.holderHeading_rad;
    const Vector2d p = member_.body.p_m - portable.holderX_m * directionOf(heading);
    // Not by rounding alone: what nobody moves stays where it is, to the bit.
    if ((p - thing.p_m).norm() < 1e-9 && std::abs(heading - thing.heading_rad) < 1e-9) return;
    thing.heading_rad = heading;
    thing.p_m = p;
  }

  const SocietyWorld& world_;
  SocietyState& state_;
  Surroundings& around_;
  std::size_t who_;
  Member& member_;
  double t_s_;
};

void seatRiders(const SocietyWorld& world, SocietyState& state) {
  for (std::size_t i = 0; i < state.things.size(); ++i) {
    const std::size_t rider = world.portables[i].rider;
    if (rider == kNobody) continue;
    state.members[rider].body.p_m = state.things[i].p_m;
    state.members[rider].body.heading_rad = state.things[i].heading_rad;
  }
}

}  // namespace

void liveOneTick(const SocietyWorld& world, SocietyState& state) {
  const double t_s = static_cast<double>(state.tick) * kTick_s;
  callEscorts(world, state, t_s);
  Surroundings around = lookAround(world, state, t_s);
  for (std::size_t i = 0; i < state.members.size(); ++i) {
    if (state.members[i].sitsIn == kNobody) Turn(world, state, around, i, t_s).take();
  }
  seatRiders(world, state);
  ++state.tick;
}

}  // namespace wardslam::synth
