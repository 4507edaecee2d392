#include "scene/scene.h"

#include <limits>

namespace wardslam::synth {
namespace {

Eigen::AlignedBox3f boundsAround(const Surfaces& surfaces) {
  Eigen::AlignedBox3f box;
  for (const Surface& surface : surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) box.extend(vertex.p_m);
  }
  return box;
}

}  // namespace

Surfaces placed(Surfaces surfaces, const Eigen::Isometry3f& T) {
  for (Surface& surface : surfaces) surface.mesh.transform(T);
  return surfaces;
}

Eigen::AlignedBox3f Actor::boundsAt(double t_s) const { return boundsAround(surfacesAt(t_s)); }

std::vector<RestInterval> Actor::restsUntil(double t_s) const {
  const double from_s = atRestFrom_s();
  if (from_s >= t_s) return {};
  return {{from_s, std::numeric_limits<double>::infinity(), boundsAt(from_s)}};
}

std::optional<RestInterval> restAt(const Actor& actor, double t_s) {
  const std::vector<RestInterval> rests = actor.restsUntil(t_s);
  if (rests.empty() || rests.back().until_s < t_s) return std::nullopt;
  return rests.back();
}

}  // namespace wardslam::synth
