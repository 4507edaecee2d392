#pragma once

#include <string>

#include "wardslam/bags/messages.h"

namespace wardslam::test {

/// The child stands so far along x in its parent.
[[nodiscard]] inline bags::Transform edge(const std::string& parent, const std::string& child, double x_m) {
  bags::Transform transform;
  transform.header.frame = parent;
  transform.child = child;
  transform.T_parent_child.translation().x() = x_m;
  return transform;
}

}  // namespace wardslam::test
