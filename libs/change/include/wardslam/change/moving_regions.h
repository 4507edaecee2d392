#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"

namespace wardslam::change {

class SceneMotion;

struct MovingRegionsOptions {
  double reach_m = 0.4;
  double strict_log_odds = 1.0;
  double loose_log_odds = 3.0;
  double min_area_m2 = 0.01;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("reach", self.reach_m, {0.0, 5.0}, "m", "motion seen at one place is taken to hold along its surface so far");
    visit("strict", self.strict_log_odds, {0.0, 4.0}, "log-odds", "from which a point moves that others bear out");
    visit("loose", self.loose_log_odds, {0.0, 4.0}, "log-odds", "from which a point moves that stands alone");
    visit("min_area", self.min_area_m2, {0.0, 1.0}, "m^2", "smallest surface that can have come");
  }
};

/// The regions of the newest image that move, of the evidence gathered: followed points, and surfaces where an earlier
/// image saw none, each borne out by its neighbours and grown along its surface until resting points are nearer.
/// `explained`: CV_8UC1 of the image's size, not 0 where motion is known of already and tells of nothing else; regions
/// may grow into it, and do not start there. CV_8UC1 of that size, 255 = moves.
[[nodiscard]] cv::Mat movingRegions(const SceneMotion& motion, const core::CameraModel& camera,
                                    const cv::Mat& explained, const MovingRegionsOptions& options);

}  // namespace wardslam::change
