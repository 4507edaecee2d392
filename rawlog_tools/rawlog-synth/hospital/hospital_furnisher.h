#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <vector>

#include "hospital/hospital_items.h"
#include "hospital/hospital_placing.h"
#include "hospital/hospital_plan.h"

namespace wardslam::synth {

/// What differs among things of a kind.
struct Looks {
  int variant = 0;
  float size_m = 1.0F;
  bool occupied = false;
  float opening_rad = 0.0F;
};

/// Numbers things as it puts them into rooms.
class Furnisher {
 public:
  Furnisher(const HospitalPlan& plan, cv::RNG rng) : plan_(plan), placing_(plan), rng_(rng) {}

  [[nodiscard]] const HospitalPlan& plan() const { return plan_; }
  [[nodiscard]] cv::RNG& rng() { return rng_; }
  /// Rooms that are furnished with the same numbers look the same.
  void useNumbers(cv::RNG rng) { rng_ = rng; }
  [[nodiscard]] std::vector<Item> take() { return std::move(items_); }

  /// Puts it there, in the room's frame, when there is room for it.
  bool put(ItemKind kind, std::size_t room, const Eigen::Isometry3f& T_room_item, const Looks& looks = {});
  /// The same, a little to the side and turned.
  bool putNudged(ItemKind kind, std::size_t room, const Eigen::Isometry3f& T_room_item, const Looks& looks = {});
  /// Somewhere along the walls of the room.
  bool putAtWall(ItemKind kind, std::size_t room, const Looks& looks = {});

 private:
  [[nodiscard]] Item made(ItemKind kind, std::size_t room, const Looks& looks);
  bool keep(Item item);

  const HospitalPlan& plan_;
  Placing placing_;
  cv::RNG rng_;
  std::vector<Item> items_;
  std::map<core::ClassId, int> counts_;
};

}  // namespace wardslam::synth
