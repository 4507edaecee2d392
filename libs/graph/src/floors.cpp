#include "floors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace wardslam::graph {
namespace {

// Finished floors may be off by 4 mm over 1 m, 10 mm over 4 m, and 15 mm over 15 m (DIN 18202): over what a camera sees
// they lean by some 0.2 degrees, and from one end to the other they rise and fall by a centimetre or two.
constexpr double kUnevenTilt_rad = 0.2 * M_PI / 180.0;
constexpr double kUnevenHeight_m = 0.01;
constexpr double kUnevenPerMetre = 0.001;

// How far a pose may have drifted before the floor takes it back.
constexpr double kDriftTilt_rad = 0.3 * M_PI / 180.0;
constexpr double kDriftHeight_m = 0.02;

constexpr double kMostTilt_rad = 1.5 * M_PI / 180.0;  // less than any ramp worth the name
constexpr double kMostStep_m = 0.05;                  // and than any step
constexpr double kMostTiltOfLook_rad = 3.0 * M_PI / 180.0;
constexpr double kMostStepOfLook_m = 0.15;
constexpr double kChiSquare = 11.345;  // 99 % of three components are below
constexpr double kWayBack_m = 5.0;     // to a keyframe that saw the ground, if those since did not
constexpr double kKernel = 3.0;        // standard deviations
constexpr int kRounds = 3;

Eigen::Matrix3d R_map_floor(const Eigen::Vector3d& normal_map) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal_map).toRotationMatrix();
}

/// Whether two planes in one camera frame may be the same, by what is known of both.
bool agree(const core::GroundPlane& plane, const core::GroundPlane& other, double mostStep_m) {
  const auto tangents = plane.tangents();
  Eigen::Vector3d off;
  off << tangents.transpose() * other.normal_cam, other.height_m - plane.height_m;
  if (plane.normal_cam.dot(other.normal_cam) < std::cos(kMostTilt_rad) || std::abs(off.z()) > mostStep_m) return false;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = tangents.transpose() * other.tangents();
  const Eigen::Matrix3d covariance = plane.covariance + turn * other.covariance * turn.transpose();
  return off.dot(covariance.ldlt().solve(off)) < kChiSquare;
}

const core::GroundPlane& groundOf(const KeyframeNode& node) { return *node.keyframe->ground; }

/// Both see one plane, as one stands to the other now: nearby that is exact.
bool standOnOne(const KeyframeNode& node, const KeyframeNode& other) {
  const Eigen::Isometry3d T_node_other = node.T_map_cam.inverse() * other.T_map_cam;
  core::GroundPlane expected = groundOf(other).seenFrom(T_node_other);
  expected.covariance += unevenness(T_node_other.translation().norm());
  return agree(groundOf(node), expected, kMostStep_m);
}

bool standsOn(const KeyframeNode& node, const Floor& floor) {
  core::GroundPlane expected = floor.under(node.T_map_cam);
  expected.covariance.diagonal() += Eigen::Vector3d(kDriftTilt_rad, kDriftTilt_rad, kDriftHeight_m).cwiseAbs2();
  return agree(groundOf(node), expected, std::numeric_limits<double>::infinity());
}

std::set<KeyframeId> standingOn(const KeyframeGraph& graph, KeyframeId floor) {
  std::set<KeyframeId> keyframes;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.floor == floor) keyframes.insert(id);
  }
  return keyframes;
}

/// Keyframes nearby that stand on a floor: the last before this one, then those that see the same, most first.
std::vector<KeyframeId> neighboursOnFloors(const KeyframeGraph& graph, KeyframeId id, std::size_t minSharedPoints) {
  const KeyframeNode& node = graph.keyframes().at(id);
  std::vector<KeyframeId> neighbours;
  for (auto before = std::make_reverse_iterator(graph.keyframes().find(id)); before != graph.keyframes().rend();
       ++before) {
    const double way_m = (before->second.T_map_cam.translation() - node.T_map_cam.translation()).norm();
    if (before->second.submap != node.submap || way_m > kWayBack_m) break;
    if (before->second.floor == 0) continue;
    neighbours.push_back(before->first);
    break;
  }
  for (const auto& [other, shared] : graph.covisible(id)) {
    const KeyframeNode& seen = graph.keyframes().at(other);
    if (shared >= minSharedPoints && seen.floor != 0 && seen.submap == node.submap) neighbours.push_back(other);
  }
  return neighbours;
}

/// Of the floors of its neighbours, those it stands on, likeliest first.
std::vector<KeyframeId> floorsUnder(const KeyframeGraph& graph, KeyframeId id, std::size_t minSharedPoints) {
  const KeyframeNode& node = graph.keyframes().at(id);
  std::map<KeyframeId, bool> isPlane;  // of each floor that was asked: its plane is there still
  std::vector<KeyframeId> floors;
  for (const KeyframeId neighbour : neighboursOnFloors(graph, id, minSharedPoints)) {
    const KeyframeNode& other = graph.keyframes().at(neighbour);
    if (std::count(floors.begin(), floors.end(), other.floor) > 0 || !standOnOne(node, other)) continue;
    const auto [asked, isNew] = isPlane.try_emplace(other.floor, false);
    if (isNew) asked->second = standsOn(node, fitFloor(graph, standingOn(graph, other.floor)));
    if (asked->second) floors.push_back(other.floor);
  }
  return floors;
}

void unite(KeyframeGraph& graph, KeyframeId from, KeyframeId into) {
  for (const KeyframeId id : standingOn(graph, from)) graph.setFloor(id, into);
}

}  // namespace

core::GroundPlane Floor::under(const Eigen::Isometry3d& T_map_cam) const {
  const Eigen::Vector3d way_m = T_map_cam.translation() - middle_map_m;
  core::GroundPlane plane;
  plane.normal_cam = T_map_cam.linear().transpose() * normal_map;
  plane.height_m = normal_map.dot(way_m) + offset_m;
  plane.covariance = unevenness(way_m.norm());
  return plane;
}

Eigen::Matrix3d unevenness(double way_m) {
  const double height_m = std::hypot(kUnevenHeight_m, kUnevenPerMetre * way_m);
  return Eigen::Vector3d(kUnevenTilt_rad, kUnevenTilt_rad, height_m).cwiseAbs2().asDiagonal();
}

std::map<KeyframeId, std::set<KeyframeId>> floorsOf(const KeyframeGraph& graph) {
  std::map<KeyframeId, std::set<KeyframeId>> floors;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.floor != 0) floors[node.floor].insert(id);
  }
  for (auto floor = floors.begin(); floor != floors.end();) {
    floor = floor->second.size() < kFewestOnFloor ? floors.erase(floor) : std::next(floor);
  }
  return floors;
}

Floor fitFloor(const KeyframeGraph& graph, const std::set<KeyframeId>& keyframes) {
  Floor floor;
  floor.normal_map.setZero();
  for (const KeyframeId id : keyframes) {
    const KeyframeNode& node = graph.keyframes().at(id);
    floor.normal_map += node.T_map_cam.linear() * groundOf(node).normal_cam;
    floor.middle_map_m += node.T_map_cam.translation() / static_cast<double>(keyframes.size());
    floor.offset_m += groundOf(node).height_m / static_cast<double>(keyframes.size());
  }
  floor.normal_map.normalize();
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Matrix3d R = R_map_floor(floor.normal_map);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const KeyframeId id : keyframes) {
      const KeyframeNode& node = graph.keyframes().at(id);
      const auto tangents = groundOf(node).tangents();
      const core::GroundPlane expected = floor.under(node.T_map_cam);
      Eigen::Vector3d off;
      off << tangents.transpose() * expected.normal_cam, expected.height_m - groundOf(node).height_m;
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
      jacobian.topLeftCorner<2, 2>() = tangents.transpose() * node.T_map_cam.linear().transpose() * R.leftCols<2>();
      jacobian.bottomLeftCorner<1, 2>() =
          (node.T_map_cam.translation() - floor.middle_map_m).transpose() * R.leftCols<2>();
      jacobian(2, 2) = 1.0;
      const Eigen::Matrix3d weight = (groundOf(node).covariance + expected.covariance).inverse();
      const double robust = 1.0 / (1.0 + off.dot(weight * off) / (kKernel * kKernel));
      information += robust * jacobian.transpose() * weight * jacobian;
      right -= robust * jacobian.transpose() * weight * off;
    }
    const Eigen::Vector3d shift = information.ldlt().solve(right);
    floor.normal_map = (R * Eigen::Vector3d(shift.x(), shift.y(), 1.0)).normalized();
    floor.offset_m += shift.z();
  }
  return floor;
}

void findFloor(KeyframeGraph& graph, KeyframeId id, std::size_t minSharedPoints) {
  if (!graph.keyframes().at(id).keyframe->ground) return;
  const auto floors = floorsUnder(graph, id, minSharedPoints);
  if (floors.empty()) {
    graph.setFloor(id, id);
    return;
  }
  graph.setFloor(id, floors.front());
  const Eigen::Isometry3d T_map_cam = graph.keyframes().at(id).T_map_cam;
  for (std::size_t i = 1; i < floors.size(); ++i) {
    const core::GroundPlane plane = fitFloor(graph, standingOn(graph, floors.front())).under(T_map_cam);
    const core::GroundPlane other = fitFloor(graph, standingOn(graph, floors[i])).under(T_map_cam);
    if (agree(plane, other, kMostStep_m)) unite(graph, floors[i], floors.front());
  }
}

bool uniteFloors(KeyframeGraph& graph, KeyframeId older, KeyframeId newer) {
  const KeyframeNode& node = graph.keyframes().at(newer);
  const KeyframeId floor = graph.keyframes().at(older).floor;
  if (floor == 0 || node.floor == 0 || floor == node.floor) return false;
  const core::GroundPlane one = fitFloor(graph, standingOn(graph, floor)).under(node.T_map_cam);
  const core::GroundPlane other = fitFloor(graph, standingOn(graph, node.floor)).under(node.T_map_cam);
  const bool isLevel = one.normal_cam.dot(other.normal_cam) > std::cos(kMostTiltOfLook_rad);
  if (!isLevel || std::abs(one.height_m - other.height_m) > kMostStepOfLook_m) return false;
  unite(graph, node.floor, floor);
  return true;
}

}  // namespace wardslam::graph
