#include "wardslam/evaluation/coverage.h"

#include <algorithm>

namespace wardslam::evaluation {

double coverage(const core::Trajectory& trajectory, double begin_s, double end_s) {
  if (end_s <= begin_s) return 0.0;
  double covered_s = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const double from_s = trajectory[i - 1].stamp_s;
    const double to_s = trajectory[i].stamp_s;
    if (to_s - from_s > kMaxGap_s) continue;
    covered_s += std::max(0.0, std::min(to_s, end_s) - std::max(from_s, begin_s));
  }
  return covered_s / (end_s - begin_s);
}

}  // namespace wardslam::evaluation
