#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::viewer {

/// From map coordinates to the pixels of drawPlan(), whose rows go down as y goes up: for those who draw upon it.
class PlanRaster {
 public:
  explicit PlanRaster(const mapping::SemanticMap& map);

  [[nodiscard]] cv::Size size() const;
  [[nodiscard]] cv::Point at(const Eigen::Vector2d& p_map_m) const;
  [[nodiscard]] int toPixels(double length_m) const { return cvRound(length_m * scale_px_per_m_); }

 private:
  Eigen::AlignedBox2d extent_;
  double scale_px_per_m_ = 1.0;
};

}  // namespace wardslam::viewer
