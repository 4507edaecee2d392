#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "life/society_world.h"

namespace wardslam::synth {

/// People and the things they move, in steps of kTick_s; in between everything moves evenly. Any time >= 0 can be
/// asked for, again and again with the same answer: what is not remembered is lived through once more. Memory does not
/// grow with time but for the list of where things rested. Safe to ask from several threads.
class Society {
 public:
  Society(SocietyWorld world, SocietyState start);

  /// What somebody or something is at one time, and whether any part of it moves just then.
  template <class State>
  struct Moment {
    State state;
    bool isMoving = false;
  };
  [[nodiscard]] Moment<BodyState> memberAt(std::size_t member, double t_s) const;
  [[nodiscard]] Moment<ThingState> thingAt(std::size_t thing, double t_s) const;

  /// Where a thing that nobody holds stands, from when to when.
  struct Rest {
    double from_s = 0.0;
    double until_s = 0.0;  ///< Infinite where it stays until the end of what was asked for.
    ThingState where;
  };
  [[nodiscard]] std::vector<Rest> restsUntil(std::size_t thing, double t_s) const;

  [[nodiscard]] const SocietyWorld& world() const { return world_; }

 private:
  struct Window {
    SocietyState end;
    std::vector<Snapshot> ticks;  ///< One more than ticks in a window: the first of the next one.
  };
  struct Between {
    Snapshot const* before;
    Snapshot const* after;
    double part;
  };

  [[nodiscard]] const Window& window(std::size_t number) const;
  [[nodiscard]] Between between(double t_s) const;
  template <class State>
  [[nodiscard]] Moment<State> momentOf(std::vector<State> Snapshot::*kind, std::size_t which, double t_s) const;
  [[nodiscard]] Window live(SocietyState state) const;
  void noteRests(const SocietyState& before, const SocietyState& after) const;

  SocietyWorld world_;
  SocietyState start_;
  mutable std::mutex mutex_;
  mutable std::map<std::size_t, Window> windows_;  ///< The latest few that were asked for.
  mutable std::vector<std::vector<Rest>> rests_;   ///< By thing.
  mutable std::uint64_t notedTicks_ = 0;
};

/// Moves everybody on by one tick.
void liveOneTick(const SocietyWorld& world, SocietyState& state);

[[nodiscard]] Snapshot seenOf(const SocietyState& state);

}  // namespace wardslam::synth
