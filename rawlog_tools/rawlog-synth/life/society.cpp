#include "life/society.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "life/steering.h"

namespace wardslam::synth {
namespace {

constexpr std::size_t kWindowTicks = 100;
constexpr std::size_t kWindowsKept = 3;
constexpr double kForGood_s = std::numeric_limits<double>::infinity();

double mix(double a, double b, double w) { return a == b ? a : (1 - w) * a + w * b; }

Eigen::Vector2d mix(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double w) {
  return {mix(a.x(), b.x(), w), mix(a.y(), b.y(), w)};
}

FigurePose mix(const FigurePose& a, const FigurePose& b, double w) {
  FigurePose pose = b;
  for (const auto part : {&FigurePose::stride_rad, &FigurePose::swing, &FigurePose::sitting, &FigurePose::seat_m,
                          &FigurePose::footrest_m, &FigurePose::reaching, &FigurePose::reachX_m, &FigurePose::reachZ_m,
                          &FigurePose::gesture, &FigurePose::turn_rad})
    pose.*part = mix(a.*part, b.*part, w);
  return pose;
}

BodyState mix(const BodyState& a, const BodyState& b, double w) {
  return {mix(a.p_m, b.p_m, w), mix(a.heading_rad, b.heading_rad, w), mix(a.pose, b.pose, w)};
}

ThingState mix(const ThingState& a, const ThingState& b, double w) {
  return {mix(a.p_m, b.p_m, w), mix(a.heading_rad, b.heading_rad, w), mix(a.z_m, b.z_m, w)};
}

}  // namespace

Snapshot seenOf(const SocietyState& state) {
  Snapshot snapshot;
  for (const Member& member : state.members) snapshot.bodies.push_back(member.body);
  snapshot.things = state.things;
  return snapshot;
}

Society::Society(SocietyWorld world, SocietyState start)
    : world_(std::move(world)), start_(std::move(start)), rests_(start_.things.size()) {
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    if (start_.heldBy[i] == kNobody) rests_[i].push_back({0.0, kForGood_s, start_.things[i]});
  }
}

void Society::noteRests(const SocietyState& before, const SocietyState& after) const {
  if (after.tick <= notedTicks_) return;
  notedTicks_ = after.tick;
  const double then_s = static_cast<double>(before.tick) * kTick_s;
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    auto& rests = rests_[i];
    const bool resting = !rests.empty() && rests.back().until_s == kForGood_s;
    const bool still = after.heldBy[i] == kNobody && after.things[i] == before.things[i];
    if (resting && !(after.things[i] == before.things[i])) rests.back().until_s = then_s;
    if (!resting && still) rests.push_back({then_s, kForGood_s, after.things[i]});
  }
}

Society::Window Society::live(SocietyState state) const {
  Window window;
  window.ticks.push_back(seenOf(state));
  for (std::size_t i = 0; i < kWindowTicks; ++i) {
    SocietyState next = state;
    liveOneTick(world_, next);
    noteRests(state, next);
    window.ticks.push_back(seenOf(next));
    state = std::move(next);
  }
  window.end = std::move(state);
  return window;
}

const Society::Window& Society::window(std::size_t number) const {
  if (const auto known = windows_.find(number); known != windows_.end()) return known->second;
  // From the nearest one before that is remembered.
  const auto after = windows_.upper_bound(number);
  std::size_t next = 0;
  SocietyState state = start_;
  if (after != windows_.begin()) {
    const auto before = std::prev(after);
    next = before->first + 1;
    state = before->second.end;
  }
  for (; next < number; ++next) state = live(std::move(state)).end;
  while (windows_.size() >= kWindowsKept) {
    // The one farthest from what is wanted now goes.
    const bool first = number > windows_.begin()->first;
    windows_.erase(first ? windows_.begin() : std::prev(windows_.end()));
  }
  return windows_.emplace(number, live(std::move(state))).first->second;
}

Society::Between Society::between(double t_s) const {
  const double ticks = std::max(0.0, t_s) / kTick_s;
  // A time that is a tick but for rounding counts as that tick.
  const double whole = std::floor(ticks + 1e-6);
  const auto tick = static_cast<std::size_t>(whole);
  const Window& there = window(tick / kWindowTicks);
  const std::size_t i = tick % kWindowTicks;
  return {&there.ticks[i], &there.ticks[i + 1], std::clamp(ticks - whole, 0.0, 1.0)};
}

template <class State>
Society::Moment<State> Society::momentOf(std::vector<State> Snapshot::*kind, std::size_t which, double t_s) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Between at = between(t_s);
  const State& a = (at.before->*kind)[which];
  const State& b = (at.after->*kind)[which];
  return {mix(a, b, at.part), !(a == b)};
}

Society::Moment<BodyState> Society::memberAt(std::size_t member, double t_s) const {
  return momentOf(&Snapshot::bodies, member, t_s);
}

Society::Moment<ThingState> Society::thingAt(std::size_t thing, double t_s) const {
  return momentOf(&Snapshot::things, thing, t_s);
}

std::vector<Society::Rest> Society::restsUntil(std::size_t thing, double t_s) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  (void)between(t_s);  // has lived that far
  std::vector<Rest> rests;
  for (Rest rest : rests_[thing]) {
    if (rest.from_s >= t_s) break;
    if (rest.until_s > t_s) rest.until_s = kForGood_s;
    rests.push_back(rest);
  }
  return rests;
}

}  // namespace wardslam::synth
