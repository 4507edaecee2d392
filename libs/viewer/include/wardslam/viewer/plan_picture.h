#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::viewer {

/// The map seen from above (CV_8UC3, BGR): the floor plan, zones, what stands on the floor in its own colours, objects
/// as boxes in the colours of their classes with their names, the camera's way, and a scale bar. The map's y axis
/// points up. Equal maps give equal pictures; a map of nothing gives a small empty one.
[[nodiscard]] cv::Mat drawPlan(const mapping::SemanticMap& map);

/// What drawPlan() draws upon: the floor plan and, in their own colours, the points above it. For those who draw the
/// rest in another way, by PlanRaster.
[[nodiscard]] cv::Mat drawGround(const mapping::SemanticMap& map);

/// Corners of the box's outline on the floor in map coordinates, in order.
[[nodiscard]] std::vector<Eigen::Vector2d> footprint(const mapping::OrientedBox& box);

/// What an object is called in pictures: "bed #3", "chair #5 (gone)".
[[nodiscard]] std::string tagOf(const mapping::MapObject& object, const core::LabelSpace& labels);

}  // namespace wardslam::viewer
