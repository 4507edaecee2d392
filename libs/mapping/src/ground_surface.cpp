#include "ground_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground_slope.h"
#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::mapping {
namespace {

constexpr double kCell_m = 0.25;
constexpr double kLayer_m = 0.02;
constexpr double kAround_m = 0.5;     // above and beneath where keyframes stand, ground is looked for
constexpr double kStoreyGap_m = 1.0;  // no ground in between: another storey
constexpr double kSeedRange_m = 3.0;  // a keyframe is sure of its own ground
constexpr std::size_t kSeedDirections = 8;
constexpr int kMinPoints = 6;  // of the cloud, for a cell to be ground
constexpr int kAncestors = 4;

}  // namespace

GroundSurface::GroundSurface(const SemanticMap& map) {
  stand(map);
  if (!isSeen_) {
    for (const auto& [id, keyframe] : map.keyframes) carried_.insert(id);
    return;
  }
  chooseStorey();
  makeCells(map);
  countPoints(map);
  spread(seed(map));
  fill();
  counts_ = {};
}

double GroundSurface::heightOver_m(const Eigen::Vector3f& p_map_m) const {
  if (!isSeen_) return static_cast<double>(p_map_m.z());
  const Eigen::Vector3d p_level_m = R_level_map_ * p_map_m.cast<double>();
  return p_level_m.z() - static_cast<double>(cells_[static_cast<std::size_t>(indexOf(p_level_m.head<2>()))].height_m);
}

/// Up is where most ground says it is.
void GroundSurface::stand(const SemanticMap& map) {
  Eigen::Vector3d up_map = Eigen::Vector3d::Zero();
  std::vector<const MappedKeyframe*> seen;
  for (const auto& [id, keyframe] : map.keyframes) {
    if (!keyframe.ground) continue;
    up_map += keyframe.T_map_cam.linear() * keyframe.ground->normal_cam;
    seen.push_back(&keyframe);
  }
  isSeen_ = up_map.norm() > 0.0;
  if (!isSeen_) return;
  R_level_map_ = Eigen::Quaterniond::FromTwoVectors(up_map, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (const auto& [id, keyframe] : map.keyframes) {
    const Eigen::Vector3d eye_m = keyframe.T_map_cam.translation();
    const auto isNearer = [&eye_m](const MappedKeyframe* a, const MappedKeyframe* b) {
      return (a->T_map_cam.translation() - eye_m).squaredNorm() < (b->T_map_cam.translation() - eye_m).squaredNorm();
    };
    const MappedKeyframe& nearest = keyframe.ground ? keyframe : **std::min_element(seen.begin(), seen.end(), isNearer);
    const Eigen::Isometry3d T_here_there = keyframe.T_map_cam.inverse() * nearest.T_map_cam;
    const core::GroundPlane plane = nearest.ground->seenFrom(T_here_there);
    const Eigen::Vector3d normal_map = keyframe.T_map_cam.linear() * plane.normal_cam;
    feet_[id] = {R_level_map_ * (eye_m - plane.height_m * normal_map), R_level_map_ * normal_map,
                 keyframe.ground.has_value()};
  }
}

/// The one with most keyframes; of several the lowest.
void GroundSurface::chooseStorey() {
  std::vector<std::pair<double, std::uint64_t>> byHeight;
  for (const auto& [id, foot] : feet_) byHeight.emplace_back(foot.p_level_m.z(), id);
  std::sort(byHeight.begin(), byHeight.end());
  std::set<std::uint64_t> storey;
  for (std::size_t i = 0; i < byHeight.size(); ++i) {
    if (i > 0 && byHeight[i].first - byHeight[i - 1].first > kStoreyGap_m) storey.clear();
    storey.insert(byHeight[i].second);
    if (storey.size() > carried_.size()) carried_ = storey;
  }
}

void GroundSurface::makeCells(const SemanticMap& map) {
  Eigen::AlignedBox3d extent;
  for (const auto& [id, foot] : feet_) {
    if (carries(id)) extent.extend(foot.p_level_m);
  }
  lowest_m_ = extent.min().z() - kAround_m;
  layers_ = static_cast<std::int32_t>(std::ceil((extent.max().z() + kAround_m - lowest_m_) / kLayer_m)) + 1;
  Eigen::AlignedBox2d floor;
  for (const auto& [id, keyframe] : map.keyframes) floor.extend(feet_.at(id).p_level_m.head<2>());
  forEachCloudPoint(map, [&](const Eigen::Vector3f& p_map_m, const SemanticPoint& /*point*/) {
    floor.extend((R_level_map_ * p_map_m.cast<double>()).head<2>());
  });
  origin_m_ = floor.min();
  columns_ = static_cast<std::int32_t>(floor.sizes().x() / kCell_m) + 1;
  rows_ = static_cast<std::int32_t>(floor.sizes().y() / kCell_m) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

void GroundSurface::countPoints(const SemanticMap& map) {
  counts_.assign(cells_.size() * static_cast<std::size_t>(layers_), 0);
  forEachCloudPoint(map, [&](const Eigen::Vector3f& p_map_m, const SemanticPoint& /*point*/) {
    const Eigen::Vector3d p_level_m = R_level_map_ * p_map_m.cast<double>();
    const double layer = (p_level_m.z() - lowest_m_) / kLayer_m;
    if (layer < 0.0 || layer >= static_cast<double>(layers_)) return;
    const auto cell = static_cast<std::size_t>(indexOf(p_level_m.head<2>()));
    auto& count = counts_[cell * static_cast<std::size_t>(layers_) + static_cast<std::size_t>(layer)];
    if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
  });
}

/// Where the cloud has ground in what a keyframe saw free, as high as that keyframe says.
std::vector<std::int32_t> GroundSurface::seed(const SemanticMap& map) {
  std::vector<std::int32_t> seeds;
  const auto take = [&](const Eigen::Vector2d& p_level_m, double height_m) {
    const std::int32_t index = indexOf(p_level_m);
    Cell& cell = cells_[static_cast<std::size_t>(index)];
    if (cell.isKnown) return;
    cell = {static_cast<float>(height_m), true, -1};
    seeds.push_back(index);
  };
  for (const auto& [id, foot] : feet_) {
    if (!carries(id) || !foot.isSeen) continue;
    const MappedKeyframe& keyframe = map.keyframes.at(id);
    for (std::size_t i = 0; i < keyframe.freeFan_cam_m.size(); i += kSeedDirections) {
      const Eigen::Vector3d way_map_m = keyframe.T_map_cam.linear() * keyframe.freeFan_cam_m[i].cast<double>();
      const Eigen::Vector2d way_m = (R_level_map_ * way_map_m).head<2>();
      const double reach_m = std::min(way_m.norm(), kSeedRange_m);
      for (double range_m = kCell_m; range_m < reach_m; range_m += kCell_m) {
        const Eigen::Vector2d offset_m = range_m * way_m.normalized();
        const Eigen::Vector2d p_level_m = foot.p_level_m.head<2>() + offset_m;
        const double rise_m = -foot.normal_level.head<2>().dot(offset_m) / foot.normal_level.z();
        double height_m = foot.p_level_m.z() + rise_m;
        if (isWithin(p_level_m) && support(indexOf(p_level_m), height_m, kGroundNoise_m, height_m))
          take(p_level_m, height_m);
      }
    }
  }
  for (const auto& [id, foot] : feet_) {
    if (carries(id) && foot.isSeen) take(foot.p_level_m.head<2>(), foot.p_level_m.z());
  }
  return seeds;
}

void GroundSurface::spread(std::vector<std::int32_t> edge) {
  for (std::size_t next = 0; next < edge.size(); ++next) {
    const std::int32_t from = edge[next];
    const auto from_m = static_cast<double>(cells_[static_cast<std::size_t>(from)].height_m);
    for (const std::int32_t to : neighbours(from)) {
      Cell& cell = cells_[static_cast<std::size_t>(to)];
      double height_m = 0.0;
      if (cell.isKnown || !support(to, from_m, kSteepest * kCell_m + kGroundNoise_m, height_m)) continue;
      if (!isNoSteeperThanARamp(from, height_m)) continue;
      cell = {static_cast<float>(height_m), true, from};
      edge.push_back(to);
    }
  }
}

/// From what is known outwards, as in spread().
void GroundSurface::fill() {
  std::vector<std::int32_t> edge;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].isKnown) edge.push_back(static_cast<std::int32_t>(i));
  }
  for (std::size_t next = 0; next < edge.size(); ++next) {
    const float height_m = cells_[static_cast<std::size_t>(edge[next])].height_m;
    for (const std::int32_t to : neighbours(edge[next])) {
      Cell& cell = cells_[static_cast<std::size_t>(to)];
      if (cell.isKnown) continue;
      cell = {height_m, true, -1};
      edge.push_back(to);
    }
  }
}

bool GroundSurface::isWithin(const Eigen::Vector2d& p_level_m) const {
  const Eigen::Vector2d cell = (p_level_m - origin_m_) / kCell_m;
  return (cell.array() >= 0.0).all() && cell.x() < columns_ && cell.y() < rows_;
}

/// Of the nearest cell where it is outside.
std::int32_t GroundSurface::indexOf(const Eigen::Vector2d& p_level_m) const {
  const Eigen::Vector2d cell = ((p_level_m - origin_m_) / kCell_m).array().floor();
  const auto column = static_cast<std::int32_t>(std::clamp(cell.x(), 0.0, static_cast<double>(columns_ - 1)));
  const auto row = static_cast<std::int32_t>(std::clamp(cell.y(), 0.0, static_cast<double>(rows_ - 1)));
  return row * columns_ + column;
}

std::vector<std::int32_t> GroundSurface::neighbours(std::int32_t cell) const {
  const std::int32_t column = cell % columns_;
  std::vector<std::int32_t> all;
  if (column > 0) all.push_back(cell - 1);
  if (column + 1 < columns_) all.push_back(cell + 1);
  if (cell >= columns_) all.push_back(cell - columns_);
  if (cell / columns_ + 1 < rows_) all.push_back(cell + columns_);
  return all;
}

/// Whether the cloud has ground in a cell about as high as expected; its mean height. What goes on above that is a
/// wall, or something that slants.
bool GroundSurface::support(std::int32_t cell, double expected_m, double tolerance_m, double& height_m) const {
  const auto layerOf = [this](double z_m) {
    return std::clamp(static_cast<std::int32_t>(std::floor((z_m - lowest_m_) / kLayer_m)), 0, layers_ - 1);
  };
  const std::int32_t last = layerOf(expected_m + tolerance_m);
  double sum = 0.0;
  int count = 0;
  int above = 0;
  for (std::int32_t layer = layerOf(expected_m - tolerance_m); layer <= layerOf(expected_m + 2 * tolerance_m);
       ++layer) {
    const int points =
        counts_[static_cast<std::size_t>(cell) * static_cast<std::size_t>(layers_) + static_cast<std::size_t>(layer)];
    if (layer > last) {
      above += points;
      continue;
    }
    sum += points * (lowest_m_ + (layer + 0.5) * kLayer_m);
    count += points;
  }
  if (count < kMinPoints || 2 * above > count) return false;
  height_m = sum / count;
  return true;
}

/// Also over several cells: what rises a little in each would climb a slanting thing.
bool GroundSurface::isNoSteeperThanARamp(std::int32_t from, double height_m) const {
  std::int32_t ancestor = from;
  for (int steps = 1; steps <= kAncestors && ancestor >= 0; ++steps) {
    const Cell& cell = cells_[static_cast<std::size_t>(ancestor)];
    if (std::abs(height_m - static_cast<double>(cell.height_m)) > kSteepest * kCell_m * steps + kGroundNoise_m)
      return false;
    ancestor = cell.parent;
  }
  return true;
}

}  // namespace wardslam::mapping
