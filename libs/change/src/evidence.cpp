#include "evidence.h"

#include <algorithm>
#include <cmath>

namespace wardslam::change {
namespace {

constexpr double kNearest_m = 0.3;  // for a depth sensor
constexpr double kBase_m = 0.04;    // with what follows: difference in depth that is none
constexpr double kSigmas = 4.0;

constexpr double kMostLogOdds = 4.0;  // nothing is ever beyond doubt

constexpr int kFew = 15;                      // fewer points of a surface tell nothing
constexpr double kForRestOfSurface = 4.0;     // of a thing that was where it is for the whole window
constexpr double kForMotionOfSurface = 12.0;  // of a thing that is elsewhere altogether; a third of it is enough

// Of a point, per image: neighbouring images see the same thing, so each adds little for rest and is bounded.
constexpr double kMostForMotion = 1.5;
constexpr double kMostForRest = 0.5;

}  // namespace

std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& p_cam_m, const core::CameraModel& camera) {
  if (p_cam_m.z() < kNearest_m) return std::nullopt;
  return camera.seenAt(p_cam_m);
}

Seen seenAt(double z_m, const DepthRange& shown, const core::DepthNoise& ofPoint, const core::DepthNoise& ofImage) {
  const double here_m = ofPoint.sigma_m(z_m);
  const double there_m = ofImage.sigma_m(shown.nearest_m);
  const double limit_m = kBase_m + kSigmas * std::sqrt(here_m * here_m + there_m * there_m);
  if (shown.nearest_m - z_m > limit_m) return Seen::Through;
  const bool isHidden = z_m - shown.farthest_m > limit_m;
  return isHidden ? Seen::Unknown : Seen::Same;
}

void SurfaceTally::add(Seen seen) {
  same_ += seen == Seen::Same ? 1 : 0;
  through_ += seen == Seen::Through ? 1 : 0;
}

std::optional<double> SurfaceTally::changed() const {
  const int decided = same_ + through_;
  return decided < kFew ? std::nullopt : std::optional(static_cast<double>(through_) / decided);
}

double evidenceOfSurface(double changed, double noise, double baseline) {
  return changed > noise ? std::min(kForMotionOfSurface * (changed - noise), kMostLogOdds)
                         : -kForRestOfSurface * baseline;
}

double evidenceOfError(double squaredError, double limit, double baseline) {
  return std::clamp(0.25 * (squaredError - limit), -kMostForRest * baseline, kMostForMotion);
}

double combined(double evidence, double another) {
  return another > 0 || evidence > 0 ? std::max(evidence, another) : std::min(evidence, another);
}

double updated(double known, double kept, double news) {
  return std::clamp(kept * known + news, -kMostLogOdds, kMostLogOdds);
}

double probabilityOf(double logOdds) { return 1.0 / (1.0 + std::exp(-logOdds)); }

}  // namespace wardslam::change
