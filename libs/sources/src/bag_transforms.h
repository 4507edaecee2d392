#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/bags/messages.h"

namespace wardslam::sources {

/// The tree of frames in a recording of ROS, and which of its transforms change.
class BagTransforms {
 public:
  void add(const bags::Transform& transform);

  /// A frame above `frame` in the tree (or itself) whose last part is one of `names`; the earliest name that there is.
  [[nodiscard]] std::optional<std::string> ancestor(const std::string& frame,
                                                    const std::vector<std::string>& names) const;

  /// p_a = T_a_b * p_b, where one of them stands above the other or both below a third. Nothing where the recording
  /// does not tell.
  [[nodiscard]] std::optional<Eigen::Isometry3d> T(const std::string& a, const std::string& b) const;

  /// A frame between the two whose place changes in the recording (by more than 1 mm or 0.1 degrees).
  [[nodiscard]] std::optional<std::string> changing(const std::string& a, const std::string& b) const;

 private:
  struct Edge {
    std::string parent;
    Eigen::Isometry3d T_parent_child;  ///< As told first.
    bool changes = false;
  };

  [[nodiscard]] std::vector<std::string> upwards(const std::string& frame) const;
  [[nodiscard]] Eigen::Isometry3d climb(const std::string& from, const std::string& to) const;
  [[nodiscard]] std::optional<std::string> meeting(const std::string& a, const std::string& b) const;

  std::map<std::string, Edge> edges_;  ///< By child.
};

}  // namespace wardslam::sources
