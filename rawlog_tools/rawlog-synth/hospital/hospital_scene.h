#pragma once

#include <memory>
#include <vector>

#include "hospital/hospital_days.h"
#include "hospital/hospital_options.h"
#include "hospital/hospital_plan.h"
#include "hospital/hospital_route.h"
#include "hospital/ways.h"
#include "place.h"

namespace wardslam::synth {

/// A hospital on one day: what it is, not yet what it looks like.
struct Hospital {
  HospitalPlan plan;
  HospitalDay today;
  HospitalRoute route;
};

[[nodiscard]] Hospital makeHospital(const SceneOptions& scene, const HospitalOptions& options);

/// Everything that stands still. A thing's instance id is its identity: the same on every day. Whoever else comes in
/// has ids from kFirstVisitorId to kFirstNewIdentity.
[[nodiscard]] Scene buildHospital(const Hospital& hospital, std::uint32_t seed);
constexpr std::uint16_t kFirstVisitorId = 10000;
constexpr std::uint16_t kFirstPatientId = 40000;  ///< Plus the number of their bed.

/// For whoever lives in it; things by their index in `scene`.
[[nodiscard]] Ways waysOf(const Hospital& hospital, const Scene& scene);

[[nodiscard]] Setting hospitalSetting(const PlaceOptions& options, const CameraMount& mount);

}  // namespace wardslam::synth
