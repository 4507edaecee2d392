#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hospital/hospital_identities.h"
#include "hospital/hospital_items.h"
#include "hospital/hospital_plan.h"

namespace wardslam::synth {

/// One thing that is not where it was the day before.
struct DayChange {
  enum class What { Moved, Swapped, Gone, New };
  int day = 0;
  What what =
      What::Moved;  ///< Swapped: it and another of its kind, in a room that looks the same, took each other's place.
  std::optional<Item> before;  ///< As on the day before; nothing when it is new,
  std::optional<Item> after;   ///< and as on that day; nothing when it is gone.
};
[[nodiscard]] const char* nameOf(DayChange::What what);

struct HospitalDay {
  std::vector<Item> items;
  std::vector<DayChange> changes;  ///< Of all days up to this one.
};

/// `day0` as it is so many days later. Every day follows from the one before.
[[nodiscard]] HospitalDay daysLater(const HospitalPlan& plan, std::vector<Item> day0, int days, std::uint32_t seed);

constexpr int kMostNewPerDay = 50;
constexpr int kLastDay = 200;

}  // namespace wardslam::synth
