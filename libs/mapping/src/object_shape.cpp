#include "object_shape.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "euclidean_clusters.h"

namespace wardslam::mapping {
namespace {

constexpr double kTrim = 0.003;
constexpr double kLeastPart = 0.1;

/// Columns are points.
Eigen::Matrix3Xd mainPart(const std::vector<Eigen::Vector3f>& points_m, double gap_m) {
  std::vector<std::size_t> kept;
  for (const auto& cluster : euclideanClusters(points_m, gap_m)) {
    const auto size = static_cast<double>(cluster.size());
    if (size >= kLeastPart * static_cast<double>(points_m.size())) {
      kept.insert(kept.end(), cluster.begin(), cluster.end());
    }
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
