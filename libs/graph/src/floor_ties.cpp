#include "floor_ties.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <algorithm>

#include "floors.h"

namespace wardslam::graph {
namespace {

constexpr double kKernel = 3.0;  // standard deviations

}  // namespace

/// How far the plane, seen from the pose, is from the ground that was measured there, in standard deviations.
struct FloorTies::Error {
  core::GroundPlane ground;
  Eigen::Matrix<double, 3, 2> tangents;
  Eigen::Matrix3d whitening;
  Eigen::Matrix3d R_map_floor;
  Eigen::Vector3d middle_map_m;
  PoseKind kind;

  template <class T>
  bool operator()(const T* pose, const T* plane, T* error) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    const Vector normal_map = R_map_floor.cast<T>() * Vector(plane[0], plane[1], T(1.0)).normalized();
    const bool isInverse = kind == PoseKind::MapFromCam;
    const T rotation_cam_map[3] = {isInverse ? T(-pose[0]) : pose[0], isInverse ? T(-pose[1]) : pose[1],
                                   isInverse ? T(-pose[2]) : pose[2]};
    const Eigen::Map<const Vector> translation(pose + 3);
    Vector normal_cam;
    ceres::AngleAxisRotatePoint(rotation_cam_map, normal_map.data(), normal_cam.data());
    const T camera_m = isInverse ? normal_map.dot(translation) : T(-normal_cam.dot(translation));
    const T height_m = camera_m - normal_map.dot(middle_map_m.cast<T>()) + plane[2];
    Vector off;
    off << tangents.transpose().cast<T>() * normal_cam, height_m - ground.height_m;
    Eigen::Map<Vector> whitened(error);
    whitened = whitening.cast<T>() * off;
    return true;
  }
};

FloorTies::FloorTies(const KeyframeGraph& graph, const std::set<KeyframeId>& keyframes) {
  for (const auto& [name, standing] : floorsOf(graph)) {
    const auto isIn = [&](KeyframeId id) { return keyframes.count(id) != 0; };
    if (std::none_of(standing.begin(), standing.end(), isIn)) continue;
    const auto isHeld = [&](KeyframeId id) { return graph.keyframes().at(id).isHeld; };
    const Floor floor = fitFloor(graph, standing);
    Plane& plane = planes_.emplace_back();
    plane.R_map_floor =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), floor.normal_map).toRotationMatrix();
    plane.middle_map_m = floor.middle_map_m;
    plane.variable.z() = floor.offset_m;
    plane.isVariable =
        std::all_of(standing.begin(), standing.end(), isIn) && std::none_of(standing.begin(), standing.end(), isHeld);
    for (const KeyframeId id : standing) {
      if (!isIn(id)) continue;
      const KeyframeNode& node = graph.keyframes().at(id);
      const Eigen::Matrix3d covariance = node.keyframe->ground->covariance + floor.under(node.T_map_cam).covariance;
      const Eigen::Matrix3d whitening = covariance.inverse().llt().matrixU();
      plane.ties.push_back({id, *node.keyframe->ground, whitening});
    }
  }
}

void FloorTies::addTo(ceres::Problem& problem, PoseKind kind, const std::function<double*(KeyframeId)>& poseOf,
                      double weight) {
  for (Plane& plane : planes_) {
    double* variable = plane.variable.data();
    for (const Tie& tie : plane.ties) {
      double* pose = poseOf(tie.keyframe);
      if (pose == nullptr) continue;
      const Eigen::Matrix<double, 3, 2> tangents = tie.ground.tangents();
      auto* error = new Error{tie.ground, tangents, tie.whitening, plane.R_map_floor, plane.middle_map_m, kind};
      auto* loss = new ceres::ScaledLoss(new ceres::CauchyLoss(kKernel), weight, ceres::TAKE_OWNERSHIP);
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Error, 3, 6, 3>(error), loss, pose, variable);
    }
    if (problem.HasParameterBlock(variable) && !plane.isVariable) problem.SetParameterBlockConstant(variable);
  }
}

std::vector<double*> FloorTies::variablePlanes() {
  std::vector<double*> variables;
  for (Plane& plane : planes_) {
    if (plane.isVariable) variables.push_back(plane.variable.data());
  }
  return variables;
}

}  // namespace wardslam::graph
