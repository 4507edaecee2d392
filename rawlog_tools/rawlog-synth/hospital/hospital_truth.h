#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "hospital/hospital_days.h"
#include "hospital/hospital_plan.h"
#include "hospital/hospital_route.h"

namespace wardslam::synth {

/// GeoJSON in metres of the world frame, of all storeys: rooms as polygons (id, name, kind, storey), doors as lines
/// (id, the two rooms, state, how far the leaf is open), the bare stretch of the corridor.
[[nodiscard]] std::string roomsGeoJson(const std::vector<const HospitalPlan*>& storeys);
/// As `wardslam run --zones` takes it.
[[nodiscard]] std::string zonesYaml(const HospitalPlan& plan);
/// What was moved, swapped, taken away and brought on each day, and from where to where (middle of its footprint).
struct DaysOfStorey {
  const HospitalPlan& plan;
  const HospitalDay& today;
};
[[nodiscard]] std::string daysCsv(const std::vector<DaysOfStorey>& storeys);
/// From above, north up: rooms, doors, things and the way driven until then. CV_8UC3.
[[nodiscard]] cv::Mat planPicture(const HospitalPlan& plan, const HospitalDay& today, const HospitalRoute& route,
                                  double until_s);

/// rooms.geojson and days.csv of all storeys, zones.yaml and plan.png of the one that is driven on. Throws
/// core::InputError when the disk does not take them.
void writeHospitalTruth(const std::filesystem::path& folder, const std::vector<DaysOfStorey>& storeys,
                        std::size_t driven, const HospitalRoute& route, double until_s);

}  // namespace wardslam::synth
