#pragma once

namespace wardslam::mapping {

/// PCL prints where it finds no plane, which here is an answer like another. It is silent while there is one of these,
/// in whatever thread: what it prints is set for the whole program.
class QuietPcl {
 public:
  QuietPcl();
  ~QuietPcl();
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;
};

}  // namespace wardslam::mapping
