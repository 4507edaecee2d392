#pragma once

#include <memory>
#include <vector>

#include "camera/camera_mount.h"
#include "hospital/hospital_days.h"
#include "hospital/hospital_options.h"
#include "hospital/hospital_plan.h"
#include "hospital/hospital_route.h"
#include "life/ways.h"
#include "scene/setting.h"

namespace wardslam::synth {

/// A storey of a hospital on one day: what it is, not yet what it looks like.
struct Hospital {
  HospitalPlan plan;
  HospitalDay today;
  HospitalRoute route;
};

/// The storey `options.storey`.
[[nodiscard]] Hospital makeHospital(const SceneOptions& scene, const HospitalOptions& options);

/// Everything that stands still, its floor at z = 0. A thing's instance id is its identity: the same on every day.
[[nodiscard]] Scene buildHospital(const Hospital& hospital, std::uint32_t seed);

/// For whoever lives in it; things by their index in `scene`.
[[nodiscard]] Ways waysOf(const Hospital& hospital, const Scene& scene);

/// Throws core::InputError when there is no such storey.
[[nodiscard]] Setting hospitalSetting(const SceneOptions& scene, const HospitalOptions& options,
                                      const CameraMount& mount);

}  // namespace wardslam::synth
