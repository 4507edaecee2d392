#include "object_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "cell_hash.h"
#include "euclidean_clusters.h"
#include "view_samples.h"

namespace wardslam::mapping {
namespace {

constexpr double kTrim = 0.003;
constexpr double kLeastPart = 0.1;

/// One point for all in a cell, so that clustering takes no longer for a dense cloud.
struct Thinned {
  std::vector<Eigen::Vector3f> points_m;
  std::vector<std::vector<std::size_t>> members;  ///< Of each point, those it stands for.
};

Thinned thin(const std::vector<Eigen::Vector3f>& points_m, float cell_m) {
  Thinned thinned;
  std::unordered_map<std::uint64_t, std::size_t, CellHash> pointOf;
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const auto [entry, isNew] = pointOf.try_emplace(cellOf(points_m[i], cell_m), thinned.points_m.size());
    if (isNew) {
      thinned.points_m.push_back(points_m[i]);
      thinned.members.emplace_back();
    }
    thinned.members[entry->second].push_back(i);
  }
  return thinned;
}

/// Columns are points.
Eigen::Matrix3Xd mainPart(const std::vector<Eigen::Vector3f>& points_m, double gap_m) {
  constexpr double kCellsPerGap = 3.0;
  const Thinned thinned = thin(points_m, static_cast<float>(gap_m / kCellsPerGap));
  std::vector<std::size_t> kept;
  for (const auto& cluster : euclideanClusters(thinned.points_m, gap_m)) {
    std::vector<std::size_t> members;
    for (const std::size_t i : cluster) {
      members.insert(members.end(), thinned.members[i].begin(), thinned.members[i].end());
    }
    if (static_cast<double>(members.size()) < kLeastPart * static_cast<double>(points_m.size())) continue;
    kept.insert(kept.end(), members.begin(), members.end());
  }
  if (kept.empty()) {
    for (std::size_t i = 0; i < points_m.size(); ++i) kept.push_back(i);
  }
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = points_m[kept[i]].cast<double>();
  }
  return points;
}

/// Least and greatest of the values, the outermost share on each side left out.
std::pair<double, double> trimmedRange(const Eigen::VectorXd& row) {
  std::vector<double> values(row.begin(), row.end());
  std::sort(values.begin(), values.end());
  const auto trim = static_cast<std::size_t>(kTrim * static_cast<double>(values.size()));
  return {values[trim], values[values.size() - 1 - trim]};
}

Eigen::AlignedBox3d trimmedBox(const Eigen::Matrix3Xd& points) {
  Eigen::AlignedBox3d box(Eigen::Vector3d::Zero().eval());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto [least, greatest] = trimmedRange(points.row(axis).transpose());
    box.min()[axis] = least;
    box.max()[axis] = greatest;
  }
  return box;
}

/// Direction of the longer principal axis in plan view.
double principalYaw_rad(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix2Xd plan = points.topRows<2>().colwise() - points.topRows<2>().rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(plan * plan.transpose());
  const Eigen::Vector2d axis = solver.eigenvectors().col(1);
  return std::atan2(axis.y(), axis.x());
}

}  // namespace

ObjectShape shapeOf(const std::vector<Eigen::Vector3f>& points_m, double gap_m) {
  const Eigen::Matrix3Xd points = mainPart(points_m, gap_m);
  ObjectShape shape;
  shape.centroid_m = points.rowwise().mean();
  shape.box_m = trimmedBox(points);
  const Eigen::Matrix3d R_map_box =
      Eigen::AngleAxisd(principalYaw_rad(points), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::AlignedBox3d turned = trimmedBox(R_map_box.transpose() * points);
  shape.orientedBox.T_map_box.linear() = R_map_box;
  shape.orientedBox.T_map_box.translation() = R_map_box * turned.center();
  shape.orientedBox.size_m = turned.sizes();
  return shape;
}

}  // namespace wardslam::mapping
