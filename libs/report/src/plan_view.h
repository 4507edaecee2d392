#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "run_record.h"
#include "wardslam/core/trajectory.h"
#include "wardslam/viewer/plan_raster.h"

namespace wardslam::report {

/// The map from above as SVG: floor and points as a picture, and upon it rooms, doors, zones, things, the way and,
/// where it is known, the true way. What can be pointed at has a <title>. Without a map, the ways alone.
class PlanView {
 public:
  /// `truthInMap` may be empty. Both must outlive the view.
  PlanView(const RunRecord& run, const core::Trajectory& truthInMap);

  /// Empty where there is nothing to draw.
  [[nodiscard]] std::string svg() const;

  /// Where a place of the map lies in the drawing.
  [[nodiscard]] cv::Point at(const Eigen::Vector3d& p_map_m) const { return raster_.at(p_map_m.head<2>()); }

 private:
  [[nodiscard]] cv::Rect box() const;
  [[nodiscard]] std::string ground() const;
  [[nodiscard]] std::string areas() const;
  [[nodiscard]] std::string doors() const;
  [[nodiscard]] std::string things() const;
  [[nodiscard]] double letterHeight() const;  ///< In the drawing.
  [[nodiscard]] std::string names() const;
  [[nodiscard]] std::string ways() const;
  [[nodiscard]] std::string scaleBar() const;
  [[nodiscard]] std::string lines(const char* kind, const core::Trajectory& way) const;
  [[nodiscard]] std::string outline(const building::Room& room) const;
  [[nodiscard]] std::string outline(const std::vector<Eigen::Vector2d>& corners_m) const;
  [[nodiscard]] std::string titleOf(const mapping::MapObject& object) const;

  const RunRecord& run_;
  const core::Trajectory& truthInMap_;
  mapping::SemanticMap map_;  ///< That of the run, with the way for keyframes where there is none.
  viewer::PlanRaster raster_;
};

}  // namespace wardslam::report
