#include "bag_transforms.h"

#include <algorithm>

namespace wardslam::sources {
namespace {

constexpr double kMoved_m = 0.001;
constexpr double kTurned_rad = 0.1 * 3.14159265358979 / 180.0;

bool differ(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Eigen::Isometry3d between = a.inverse() * b;
  return between.translation().norm() > kMoved_m || Eigen::AngleAxisd(between.linear()).angle() > kTurned_rad;
}

/// "base_link" of "robot1/base_link".
std::string lastPart(const std::string& frame) { return frame.substr(frame.find_last_of('/') + 1); }

}  // namespace

void BagTransforms::add(const bags::Transform& transform) {
  const auto [edge, isNew] =
      edges_.try_emplace(transform.child, Edge{transform.header.frame, transform.T_parent_child, false});
  if (isNew || edge->second.parent != transform.header.frame) return;
  if (differ(edge->second.T_parent_child, transform.T_parent_child)) edge->second.changes = true;
}

/// The frame itself and those above it. Ends where a recording says that one stands above itself.
std::vector<std::string> BagTransforms::upwards(const std::string& frame) const {
  std::vector<std::string> frames = {frame};
  for (auto edge = edges_.find(frame); edge != edges_.end(); edge = edges_.find(frames.back())) {
    if (std::find(frames.begin(), frames.end(), edge->second.parent) != frames.end()) break;
    frames.push_back(edge->second.parent);
  }
  return frames;
}

std::optional<std::string> BagTransforms::ancestor(const std::string& frame,
                                                   const std::vector<std::string>& names) const {
  const auto above = upwards(frame);
  for (const std::string& name : names) {
    const auto found = std::find_if(above.begin(), above.end(), [&](const std::string& candidate) {
      return candidate == name || lastPart(candidate) == name;
    });
    if (found != above.end()) return *found;
  }
  return std::nullopt;
}

std::optional<std::string> BagTransforms::meeting(const std::string& a, const std::string& b) const {
  const auto aboveA = upwards(a);
  for (const std::string& frame : upwards(b)) {
    if (std::find(aboveA.begin(), aboveA.end(), frame) != aboveA.end()) return frame;
  }
  return std::nullopt;
}

/// T_to_from, where `to` stands above.
Eigen::Isometry3d BagTransforms::climb(const std::string& from, const std::string& to) const {
  Eigen::Isometry3d T_to_from = Eigen::Isometry3d::Identity();
  for (std::string frame = from; frame != to;) {
    const Edge& edge = edges_.at(frame);
    T_to_from = edge.T_parent_child * T_to_from;
    frame = edge.parent;
  }
  return T_to_from;
}

std::optional<Eigen::Isometry3d> BagTransforms::T(const std::string& a, const std::string& b) const {
  const auto common = meeting(a, b);
  if (!common) return std::nullopt;
  return climb(a, *common).inverse() * climb(b, *common);
}

std::optional<std::string> BagTransforms::changing(const std::string& a, const std::string& b) const {
  const auto common = meeting(a, b);
  for (const std::string& end : {a, b}) {
    for (std::string frame = end; common && frame != *common;) {
      const Edge& edge = edges_.at(frame);
      if (edge.changes) return frame;
      frame = edge.parent;
    }
  }
  return std::nullopt;
}

}  // namespace wardslam::sources
