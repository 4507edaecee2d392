#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "hospital/hospital_drives.h"
#include "hospital/hospital_items.h"
#include "hospital/hospital_plan.h"

namespace wardslam::synth {

/// Finds room for things: clear of walls, doors, ways and other things.
class Placing {
 public:
  explicit Placing(const HospitalPlan& plan);

  /// Nothing of it is in a wall, in the way of a door or of those who drive. Hanging things always are clear.
  [[nodiscard]] bool isClear(const Item& item) const;
  [[nodiscard]] bool isFree(const Item& item, const std::vector<Item>& others) const;

  /// A pose in the room, with its back or, where it is long, its side to a wall; nothing when there is none to find.
  [[nodiscard]] std::optional<Eigen::Isometry3f> atWall(Item item, std::size_t room, const std::vector<Item>& others,
                                                        cv::RNG& rng) const;
  /// Anywhere in the room.
  [[nodiscard]] std::optional<Eigen::Isometry3f> anywhere(Item item, std::size_t room, const std::vector<Item>& others,
                                                          cv::RNG& rng) const;

 private:
  [[nodiscard]] bool sparesDoors(const Item& item) const;

  const HospitalPlan& plan_;
  std::vector<Polyline> drives_;
};

constexpr double kDriveClearance_m = 0.5;
constexpr double kGap_m = 0.04;  ///< Between things.

}  // namespace wardslam::synth
