#include "hospital/hospital_route.h"

#include <algorithm>
#include <cmath>

#include "camera/camera_path.h"
#include "hospital/hospital_tour.h"

namespace wardslam::synth {
namespace {

constexpr double kBend_m = 0.6;   ///< Radius, where there is room for it.
constexpr double kSway_s = 60.0;  ///< A camera sways so many cycles a minute.
constexpr double kLookAbout_rad = 0.16;

/// Per corner: what its sides leave to it.
std::vector<double> radiiFor(const Polyline& corners_m) {
  const std::size_t n = corners_m.size();
  std::vector<double> radii_m;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d before = corners_m[i] - corners_m[(i + n - 1) % n];
    const Eigen::Vector2d after = corners_m[(i + 1) % n] - corners_m[i];
    const double turn = std::acos(std::clamp(before.normalized().dot(after.normalized()), -1.0, 1.0));
    const double cut_m = 0.48 * std::min(before.norm(), after.norm());
    radii_m.push_back(std::min(kBend_m, cut_m / std::tan(std::max(turn, 1e-3) / 2)));
  }
  return radii_m;
}

ClosedRoute routeAlong(const Polyline& corners_m) { return {corners_m, radiiFor(corners_m)}; }

/// The speed every so many metres: slow enough for the bend, and for the one that comes.
std::vector<double> speedsOn(const ClosedRoute& route, double step_m) {
  constexpr double kSlowest_mps = 0.2;
  constexpr double kBraking_mps2 = 0.5;
  const auto count = static_cast<std::size_t>(std::ceil(route.length_m() / step_m));
  std::vector<double> speeds(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s_m = static_cast<double>(i) * step_m;
    const double turn = std::abs(route.at(s_m + step_m / 2).heading_rad - route.at(s_m - step_m / 2).heading_rad);
    const double fast = HospitalRoute::kTurning_rps * step_m / std::max(turn, 1e-9);
    speeds[i] = std::clamp(fast, kSlowest_mps, HospitalRoute::kSpeed_mps);
  }
  const auto easeInto = [&](std::size_t next, std::size_t here) {
    speeds[here] = std::min(speeds[here], std::sqrt(speeds[next] * speeds[next] + 2 * kBraking_mps2 * step_m));
  };
  for (std::size_t k = 2 * count; k-- > 1;) easeInto(k % count, (k - 1) % count);  // braking, twice around
  for (std::size_t k = 1; k < 2 * count; ++k) easeInto((k - 1) % count, k % count);
  return speeds;
}

}  // namespace

HospitalRoute::HospitalRoute(const HospitalPlan& plan, const RouteChoice& choice, std::uint32_t seed)
    : route_(routeAlong(cornersOf(plan, choice, seed))) {
  constexpr double kMeasured_m = 0.05;
  const std::vector<double> speeds = speedsOn(route_, kMeasured_m);
  double s_m = 0.0;
  while (s_m < route_.length_m()) {
    at_m_.push_back(s_m);
    const auto i = std::min(static_cast<std::size_t>(s_m / kMeasured_m), speeds.size() - 1);
    s_m += speeds[i] * kStep_s;
  }
  // The round closes at a whole number of steps.
  at_m_.push_back(s_m);
  for (double& at_m : at_m_) at_m *= route_.length_m() / s_m;
}

ClosedRoute::Place HospitalRoute::at(double t_s) const {
  const double rounds = std::floor(t_s / round_s());
  const double steps = (t_s - rounds * round_s()) / kStep_s;
  const auto i = std::min(static_cast<std::size_t>(steps), at_m_.size() - 2);
  const double w = steps - static_cast<double>(i);
  return route_.at(rounds * length_m() + (1 - w) * at_m_[i] + w * at_m_[i + 1]);
}

Eigen::Isometry3d HospitalRoute::T_world_cam(double t_s, const CameraMount& mount) const {
  const auto place = at(t_s);
  // A whole number of cycles a round, so that it closes.
  const double swaysPerRound = std::max(1.0, std::round(round_s() / kSway_s));
  return drivenCamera({place.p_m, place.heading_rad, kLookAbout_rad, mount}, t_s / round_s() * swaysPerRound);
}

}  // namespace wardslam::synth
