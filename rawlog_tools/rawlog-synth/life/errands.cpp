#include "life/errands.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;
using Kind = Step::Kind;

double between(std::uint64_t& dice, double low, double high) { return low + (high - low) * rollDice(dice); }

std::size_t pick(std::uint64_t& dice, std::size_t count) {
  return std::min(count - 1, static_cast<std::size_t>(rollDice(dice) * static_cast<double>(count)));
}

/// Of a few by chance the one nearest to where the camera soon comes, or just any. kNobody: none fits.
template <class Fits, class Place>
std::size_t choose(const SocietyWorld& world, std::uint64_t& dice, double t_s, std::size_t count, Fits fits,
                   Place place) {
  if (count == 0) return kNobody;
  const Vector2d camera = world.camera_m(t_s + between(dice, 8.0, 30.0));
  const bool near = rollDice(dice) < world.nearCamera;
  std::size_t best = kNobody;
  double best_m = 0.0;
  for (int i = 0; i < 12; ++i) {
    const std::size_t one = pick(dice, count);
    if (!fits(one)) continue;
    const double distance_m = (place(one) - camera).norm();
    if (best != kNobody && (!near || distance_m >= best_m)) continue;
    best = one;
    best_m = distance_m;
  }
  return best;
}

/// Things to do, first to last.
void setSteps(Member& member, std::vector<Step> steps) {
  std::reverse(steps.begin(), steps.end());
  member.steps = std::move(steps);
  member.onPath = 0;
  member.done_s = 0.0;
}

std::size_t startNode(const SocietyWorld& world, const Vector2d& p_m) {
  for (const double halfWidth_m : {0.3, 0.2, 0.1, 0.05}) {
    const std::size_t node = reachableNode(world, p_m, halfWidth_m);
    if (node != kNobody) return node;
  }
  return world.ways.nearestNode(p_m);
}

Step wait(double seconds, bool talks = false) {
  Step step;
  step.seconds = seconds;
  step.talks = talks;
  return step;
}

Step face(double heading_rad) {
  Step step;
  step.kind = Kind::Face;
  step.heading_rad = heading_rad;
  return step;
}

Step with(Kind kind, std::size_t index = 0) {
  Step step;
  step.kind = kind;
  step.index = index;
  return step;
}

/// From where the member is over `node` to `end_m`.
Step walk(const SocietyWorld& world, const Member& member, std::size_t node, const Vector2d& end_m) {
  Step step;
  step.kind = Kind::Walk;
  step.path_m = pathBetween(world, startNode(world, member.body.p_m), node, 0.0);
  step.path_m.push_back(end_m);
  return step;
}

bool restSomewhere(const SocietyWorld& world, SocietyState& state, std::size_t who, double t_s,
                   RestingPlace::Kind kind) {
  Member& member = state.members[who];
  const auto fits = [&](std::size_t i) { return world.places[i].kind == kind && state.placeTaken[i] == kNobody; };
  const std::size_t chosen =
      choose(world, member.dice, t_s, world.places.size(), fits, [&](std::size_t i) { return world.places[i].p_m; });
  if (chosen == kNobody) return false;
  const RestingPlace& place = world.places[chosen];
  state.placeTaken[chosen] = who;
  const bool group = kind == RestingPlace::Kind::Group;
  std::vector<Step> steps = {walk(world, member, place.wayNode, place.p_m), face(place.heading_rad)};
  if (kind == RestingPlace::Kind::Seat) {
    steps.push_back(with(Kind::SitDown));
    steps.back().seat_m = place.seat_m;
    steps.push_back(wait(between(member.dice, 20.0, 120.0)));
    steps.push_back(with(Kind::GetUp));
  } else {
    steps.push_back(wait(between(member.dice, 8.0, group ? 70.0 : 40.0), group));
  }
  steps.push_back(with(Kind::Free, chosen));
  setSteps(member, std::move(steps));
  return true;
}

Vector2d holderPlace(const Portable& portable, const ThingState& thing) {
  return thing.p_m + portable.holderX_m * directionOf(thing.heading_rad);
}

bool isFreeOfThings(const SocietyState& state, const Vector2d& p_m) {
  return std::none_of(state.things.begin(), state.things.end(),
                      [&](const ThingState& thing) { return (thing.p_m - p_m).norm() < 1.5; });
}

/// Takes a thing to a place where it may stand.
bool moveSomething(const SocietyWorld& world, SocietyState& state, std::size_t who, double t_s) {
  Member& member = state.members[who];
  const auto isFree = [&](std::size_t i) {
    const Vector2d p = holderPlace(world.portables[i], state.things[i]);
    return state.heldBy[i] == kNobody && world.walls.at(p) > 0.2 && reachableNode(world, p, 0.15) != kNobody;
  };
  const std::size_t chosen =
      choose(world, member.dice, t_s, state.things.size(), isFree, [&](std::size_t i) { return state.things[i].p_m; });
  if (chosen == kNobody) return false;
  const Portable& portable = world.portables[chosen];
  const ThingState& thing = state.things[chosen];
  const double halfWidth_m = portable.carried ? 0.3 : portable.width_m / 2;
  const Vector2d pivot = thing.p_m + portable.pivotX_m * directionOf(thing.heading_rad);
  const std::size_t from = reachableNode(world, pivot, portable.carried ? 0.0 : halfWidth_m - 0.05);
  const auto fits = [&](std::size_t i) {
    const RestingPlace& place = world.places[i];
    return place.kind == RestingPlace::Kind::Parking && state.placeTaken[i] == kNobody &&
           (place.p_m - thing.p_m).norm() > 4.0 && world.walls.at(place.p_m) > halfWidth_m &&
           isFreeOfThings(state, place.p_m);
  };
  const std::size_t goal =
      choose(world, member.dice, t_s, world.places.size(), fits, [&](std::size_t i) { return world.places[i].p_m; });
  if (from == kNobody || goal == kNobody) return false;
  Step push;
  push.kind = Kind::Walk;
  push.exact = false;
  push.path_m = pathBetween(world, from, world.places[goal].wayNode, halfWidth_m);
  if (push.path_m.empty()) return false;
  push.path_m.push_back(world.places[goal].p_m);
  const Vector2d there = holderPlace(portable, thing);
  setSteps(member, {walk(world, member, reachableNode(world, there, 0.15), there),
                    face(thing.heading_rad + portable.holderHeading_rad), with(Kind::Grip, chosen), push,
                    with(Kind::Release, chosen), wait(1.0)});
  return true;
}

/// With something in hand that cannot stay here: on to another place.
void moveOn(const SocietyWorld& world, SocietyState& state, std::size_t who) {
  Member& member = state.members[who];
  const Portable& portable = world.portables[member.holds];
  const ThingState& thing = state.things[member.holds];
  const double halfWidth_m = portable.carried ? 0.3 : portable.width_m / 2;
  const std::size_t from = startNode(world, thing.p_m + portable.pivotX_m * directionOf(thing.heading_rad));
  for (int attempt = 0; attempt < 30 && !world.places.empty(); ++attempt) {
    const RestingPlace& place = world.places[pick(member.dice, world.places.size())];
    if (place.kind != RestingPlace::Kind::Parking || !isFreeOfThings(state, place.p_m)) continue;
    Step push = with(Kind::Walk);
    push.exact = false;
    push.path_m = pathBetween(world, from, place.wayNode, halfWidth_m);
    if (push.path_m.empty()) continue;
    push.path_m.push_back(place.p_m);
    return setSteps(member, {wait(1.0), push, with(Kind::Release, member.holds), wait(1.0)});
  }
  setSteps(member, {wait(2.0)});
}

void walkSomewhere(const SocietyWorld& world, SocietyState& state, std::size_t who, double t_s) {
  Member& member = state.members[who];
  const auto& nodes = world.ways.graph().nodes_m;
  const std::size_t goal = choose(
      world, member.dice, t_s, nodes.size(), [&](std::size_t i) { return (nodes[i] - member.body.p_m).norm() > 3.0; },
      [&](std::size_t i) { return nodes[i]; });
  if (goal == kNobody) return setSteps(member, {wait(2.0)});
  Step step = walk(world, member, goal, nodes[goal]);
  step.exact = false;
  setSteps(member, {step, wait(between(member.dice, 0.0, 3.0))});
}

struct EscortSlot {
  double ahead_m;
  double left_m;
};
constexpr std::array<EscortSlot, 8> kSlots = {
    {{0.95, 0.24}, {0.98, -0.26}, {1.55, 0.0}, {1.6, 0.62}, {1.65, -0.62}, {2.3, 0.3}, {2.35, -0.35}, {-1.1, 0.2}}};
constexpr double kEscortEvery_s = 45.0;
constexpr double kEscortLasts_s = 24.0;

}  // namespace

double rollDice(std::uint64_t& dice) {
  dice += 0x9E3779B97F4A7C15ULL;  // splitmix64
  std::uint64_t z = dice;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1.0p-53;
}

void takeErrand(const SocietyWorld& world, SocietyState& state, std::size_t who, double t_s) {
  for (std::size_t& holder : state.placeTaken) {
    if (holder == who) holder = kNobody;  // of an errand given up
  }
  if (state.members[who].holds != kNobody) return moveOn(world, state, who);
  const double what = rollDice(state.members[who].dice);
  bool done = false;
  if (what < 0.16) {
    done = restSomewhere(world, state, who, t_s, RestingPlace::Kind::Seat);
  } else if (what < 0.34) {
    done = restSomewhere(world, state, who, t_s, RestingPlace::Kind::Group);
  } else if (what < 0.46) {
    done = restSomewhere(world, state, who, t_s, RestingPlace::Kind::Spot);
  } else if (what < 0.66) {
    done = moveSomething(world, state, who, t_s);
  }
  if (!done) walkSomewhere(world, state, who, t_s);
}

Vector2d escortPlace(const SocietyWorld& world, std::size_t index, double t_s) {
  const EscortSlot& slot = kSlots[index % kSlots.size()];
  constexpr double kStep_s = 0.2;
  Vector2d p = world.camera_m(t_s);
  Vector2d along = Vector2d::Zero();
  double way_m = 0.0;
  const double sign = slot.ahead_m < 0 ? -1.0 : 1.0;
  for (int i = 1; i < 60 && way_m < std::abs(slot.ahead_m); ++i) {
    const Vector2d next = world.camera_m(std::max(0.0, t_s + sign * kStep_s * i));
    if ((next - p).norm() > 1e-6) along = sign * (next - p).normalized();
    way_m += (next - p).norm();
    p = next;
  }
  return p + slot.left_m * Vector2d(-along.y(), along.x());
}

void callEscorts(const SocietyWorld& world, SocietyState& state, double t_s) {
  const double inRound_s = std::fmod(t_s, kEscortEvery_s);
  if (!world.escorts || inRound_s > kEscortLasts_s) return;
  const Vector2d camera = world.camera_m(t_s);
  std::array<bool, kSlots.size()> taken{};
  for (const Member& member : state.members) {
    if (!member.steps.empty() && member.steps.back().kind == Kind::Escort) taken[member.steps.back().index] = true;
  }
  for (std::size_t slot = 0; slot < kSlots.size(); ++slot) {
    if (taken[slot]) continue;
    const Vector2d place = escortPlace(world, slot, t_s);
    std::size_t best = kNobody;
    double best_m = 7.0;
    for (std::size_t i = 0; i < state.members.size(); ++i) {
      const Member& member = state.members[i];
      const bool free = member.holds == kNobody && member.sitsIn == kNobody && !member.steps.empty() &&
                        (member.steps.back().kind == Kind::Walk || member.steps.back().kind == Kind::Wait) &&
                        member.body.pose.sitting == 0;
      const double distance_m = (member.body.p_m - place).norm();
      if (!free || distance_m >= best_m || world.walls.along(member.body.p_m, camera) < 0.15) continue;
      best = i;
      best_m = distance_m;
    }
    if (best == kNobody) continue;
    for (std::size_t& holder : state.placeTaken) {
      if (holder == best) holder = kNobody;
    }
    Step step = with(Kind::Escort, slot);
    step.seconds = kEscortLasts_s - inRound_s;
    setSteps(state.members[best], {step});
  }
}

}  // namespace wardslam::synth
