#include "scene/floor_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wardslam::synth {
namespace {

constexpr double kCell_m = 0.02;
constexpr float kSample_m = 0.01F;  ///< Finer than the cells, so that no surface has holes.
constexpr float kLowest_m = 0.05F;
constexpr float kHighest_m = 1.8F;
constexpr double kMargin_m = 0.2;

/// The corner where the two shorter edges meet comes first: less is sampled twice along a long and narrow triangle.
std::array<Eigen::Vector3f, 3> withLongestEdgeLast(const Vertex* corners) {
  std::array<float, 3> opposite{};  // lengths of the edges that do not touch the corner
  for (std::size_t i = 0; i < 3; ++i) opposite[i] = (corners[(i + 1) % 3].p_m - corners[(i + 2) % 3].p_m).norm();
  const auto first = static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
  return {corners[first].p_m, corners[(first + 1) % 3].p_m, corners[(first + 2) % 3].p_m};
}

int stepsAlong(const Eigen::Vector3f& edge_m) {
  return std::max(1, static_cast<int>(std::ceil(edge_m.norm() / kSample_m)));
}

/// Calls `use` with points of a triangle in a robot's way, as seen from above: along rows from edge to edge.
template <typename Use>
void sample(const Vertex* corners, float floorZ_m, Use&& use) {
  const auto [a, b, c] = withLongestEdgeLast(corners);
  const Eigen::Vector3f u = b - a;
  const Eigen::Vector3f v = c - a;
  const float lowest_m = floorZ_m + kLowest_m;
  const float highest_m = floorZ_m + kHighest_m;
  const float heights[] = {a.z(), b.z(), c.z()};
  if (*std::max_element(heights, heights + 3) < lowest_m || *std::min_element(heights, heights + 3) > highest_m) return;
  const int rows = stepsAlong(u);
  for (int i = 0; i <= rows; ++i) {
    const float across = static_cast<float>(i) / static_cast<float>(rows);
    const Eigen::Vector3f from = a + across * u;
    const Eigen::Vector3f row = (1.0F - across) * v;
    const int steps = stepsAlong(row);
    for (int j = 0; j <= steps; ++j) {
      const Eigen::Vector3f p = from + row * (static_cast<float>(j) / static_cast<float>(steps));
      if (p.z() >= lowest_m && p.z() <= highest_m) use(Eigen::Vector2f(p.head<2>()));
    }
  }
}

template <typename Use>
void sample(const Surfaces& surfaces, float floorZ_m, Use&& use) {
  for (const Surface& surface : surfaces) {
    const auto& vertices = surface.mesh.vertices;
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) sample(&vertices[i], floorZ_m, use);
  }
}

template <typename Use>
void sample(const Scene& scene, double until_s, float floorZ_m, Use&& use) {
  for (const Thing& thing : scene.things) sample(thing.surfaces, floorZ_m, use);
  for (const auto& actor : scene.actors) {
    if (restAt(*actor, until_s)) sample(actor->surfacesAt(until_s), floorZ_m, use);
  }
}

}  // namespace

mapping::FloorPlan trueFloor(const Scene& scene, double until_s) { return trueFloorAt(scene, until_s, 0.0F); }

mapping::FloorPlan trueFloorAt(const Scene& scene, double until_s, float floorZ_m) {
  // Twice over the same points: those of a whole building are too many to be kept.
  Eigen::AlignedBox2f extent;
  sample(scene, until_s, floorZ_m, [&](const Eigen::Vector2f& p) { extent.extend(p); });
  mapping::FloorPlan plan;
  plan.resolution_m = kCell_m;
  if (extent.isEmpty()) return plan;

  plan.origin_m = extent.min().cast<double>().array() - kMargin_m;
  const Eigen::Vector2d cells = (extent.sizes().cast<double>().array() + 2 * kMargin_m) / kCell_m;
  plan.cells = cv::Mat(static_cast<int>(std::ceil(cells.y())), static_cast<int>(std::ceil(cells.x())), CV_8UC1,
                       cv::Scalar(mapping::FloorPlan::kFree));
  sample(scene, until_s, floorZ_m, [&](const Eigen::Vector2f& p) {
    const Eigen::Vector2d cell = ((p.cast<double>() - plan.origin_m) / kCell_m).array().floor();
    plan.cells.at<unsigned char>(static_cast<int>(cell.y()), static_cast<int>(cell.x())) =
        mapping::FloorPlan::kOccupied;
  });
  return plan;
}

}  // namespace wardslam::synth
