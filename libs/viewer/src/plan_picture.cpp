#include "wardslam/viewer/plan_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "drawing.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/viewer/label_layout.h"
#include "wardslam/viewer/plan_raster.h"

namespace wardslam::viewer {
namespace {

using mapping::FloorPlan;
using mapping::MapObject;
using mapping::ObjectState;

const cv::Scalar kUnknownFloor(228, 226, 224);
const cv::Scalar kFreeFloor(255, 255, 255);
const cv::Scalar kWall(120, 112, 104);
const cv::Scalar kDarkInk(60, 52, 44);
const cv::Scalar kWay(200, 80, 20);
constexpr double kZoneOpacity = 0.14;
constexpr double kObjectOpacity = 0.30;
constexpr float kCeiling_m = 2.2F;  // what hangs higher would cover what stands below

class PlanPainter {
 public:
  explicit PlanPainter(const mapping::SemanticMap& map)
      : map_(map), raster_(map), picture_(raster_.size(), CV_8UC3, kUnknownFloor) {}

  [[nodiscard]] cv::Mat paint() {
    paintGround();
    for (const auto& zone : map_.zones) paintZone(zone);
    paintWay();
    for (const auto& [id, object] : map_.objects) paintObject(object);
    nameObjects();
    paintScaleBar();
    return picture_;
  }

  cv::Mat paintGround() {
    paintFloor();
    paintCloud();
    return picture_;
  }

 private:
  void paintFloor();
  void paintCloud();
  void paintZone(const mapping::Zone& zone);
  void paintWay();
  void paintObject(const MapObject& object);
  void nameObjects();
  void paintScaleBar();
  [[nodiscard]] std::vector<cv::Point> outline(const std::vector<Eigen::Vector2d>& corners_m) const;

  const mapping::SemanticMap& map_;
  const PlanRaster raster_;
  cv::Mat picture_;
};

std::vector<cv::Point> PlanPainter::outline(const std::vector<Eigen::Vector2d>& corners_m) const {
  std::vector<cv::Point> corners;
  for (const auto& corner_m : corners_m) corners.push_back(raster_.at(corner_m));
  return corners;
}

void PlanPainter::paintFloor() {
  const FloorPlan& plan = map_.floorPlan;
  for (int row = 0; row < plan.cells.rows; ++row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      const auto cell = plan.cells.at<unsigned char>(row, column);
      if (cell == FloorPlan::kUnknown) continue;
      const cv::Point lower = raster_.at(plan.origin_m + plan.resolution_m * Eigen::Vector2d(column, row));
      const cv::Point upper = raster_.at(plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 1, row + 1));
      cv::rectangle(picture_, cv::Rect(lower, upper), cell == FloorPlan::kFree ? kFreeFloor : kWall, cv::FILLED);
    }
  }
}

/// Higher points cover lower ones; the floor itself stays white.
void PlanPainter::paintCloud() {
  constexpr float kFloor_m = 0.05F;
  cv::Mat height_m(picture_.size(), CV_32FC1, cv::Scalar(kFloor_m));
  const int size_px = std::max(1, raster_.toPixels(0.02));
  mapping::forEachCloudPoint(map_, [&](const Eigen::Vector3f& p, const mapping::SemanticPoint& point) {
    const cv::Rect dot = cv::Rect(raster_.at(p.head<2>().cast<double>()), cv::Size(size_px, size_px)) &
                         cv::Rect({0, 0}, picture_.size());
    if (dot.empty() || p.z() > kCeiling_m || p.z() <= height_m.at<float>(dot.tl())) return;
    height_m(dot).setTo(p.z());
    picture_(dot).setTo(cv::Scalar(point.color_rgb[2], point.color_rgb[1], point.color_rgb[0]));
  });
}

void PlanPainter::paintZone(const mapping::Zone& zone) {
  const auto corners = outline(zone.polygon_m);
  cv::Mat mask(picture_.size(), CV_8UC1, cv::Scalar(0));
  cv::fillPoly(mask, std::vector{corners}, cv::Scalar(255));
  const std::size_t number = static_cast<std::size_t>(&zone - map_.zones.data());
  static const std::array<cv::Scalar, 4> kColors{{{60, 160, 40}, {30, 150, 230}, {40, 50, 210}, {190, 90, 160}}};
  const cv::Scalar& color = kColors.at(number % kColors.size());
  blend(picture_, color, kZoneOpacity, mask);
  cv::polylines(picture_, std::vector{corners}, true, color, 2, cv::LINE_AA);
  const cv::Rect inside = cv::boundingRect(corners) & cv::Rect({0, 0}, picture_.size());
  if (!inside.empty()) writeTag(picture_, zone.name, inside.tl() + cv::Point(4, 4), color * 0.6);
}

void PlanPainter::paintWay() {
  std::vector<cv::Point> way;
  for (const auto& [id, keyframe] : map_.keyframes)
    way.push_back(raster_.at(keyframe.T_map_cam.translation().head<2>()));
  if (way.empty()) return;
  cv::polylines(picture_, std::vector{way}, false, kWay, 2, cv::LINE_AA);
  cv::circle(picture_, way.front(), 6, kWay, 2, cv::LINE_AA);
  cv::circle(picture_, way.back(), 6, kWay, cv::FILLED, cv::LINE_AA);
}

void PlanPainter::paintObject(const MapObject& object) {
  const cv::Scalar color(object.color_rgb[2], object.color_rgb[1], object.color_rgb[0]);
  const auto corners = outline(footprint(object.orientedBox));
  if (object.state != ObjectState::Gone) {
    cv::Mat mask(picture_.size(), CV_8UC1, cv::Scalar(0));
    cv::fillConvexPoly(mask, corners, cv::Scalar(255));
    blend(picture_, color, kObjectOpacity, mask);
  }
  cv::polylines(picture_, std::vector{corners}, true, color * 0.7, 2, cv::LINE_AA);
}

void PlanPainter::nameObjects() {
  std::vector<cv::Rect> wanted;
  for (const auto& [id, object] : map_.objects) {
    const cv::Size size = tagSize(tagOf(object, map_.labels));
    wanted.emplace_back(raster_.at(object.orientedBox.T_map_box.translation().head<2>()) - cv::Point(size / 2), size);
  }
  const auto places = movedApart(wanted, picture_.size());
  auto place = places.begin();
  for (const auto& [id, object] : map_.objects) {
    const cv::Scalar color(object.color_rgb[2], object.color_rgb[1], object.color_rgb[0]);
    writeTag(picture_, tagOf(object, map_.labels), (place++)->tl(), color * 0.45);
  }
}

void PlanPainter::paintScaleBar() {
  const int metre_px = raster_.toPixels(1.0);
  const cv::Point left(12, picture_.rows - 14);
  if (left.y < 14 || metre_px + 24 > picture_.cols) return;
  cv::line(picture_, left, left + cv::Point(metre_px, 0), kDarkInk, 3);
  cv::putText(picture_, "1 m", left + cv::Point(4, -6), kFont, kTextScale, kDarkInk, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat drawPlan(const mapping::SemanticMap& map) { return PlanPainter(map).paint(); }

cv::Mat drawGround(const mapping::SemanticMap& map) { return PlanPainter(map).paintGround(); }

std::vector<Eigen::Vector2d> footprint(const mapping::OrientedBox& box) {
  const Eigen::Vector3d half = box.size_m / 2.0;
  std::vector<Eigen::Vector2d> corners;
  for (const auto& [x, y] : {std::array{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
    corners.emplace_back((box.T_map_box * Eigen::Vector3d(x * half.x(), y * half.y(), 0.0)).head<2>());
  }
  return corners;
}

std::string tagOf(const mapping::MapObject& object, const core::LabelSpace& labels) {
  const std::string& name = labels.name(object.classId);
  const std::string text =
      (name.empty() ? "class " + std::to_string(object.classId) : name) + " #" + std::to_string(object.id);
  return object.state == ObjectState::Static ? text : text + " (" + toString(object.state) + ")";
}

}  // namespace wardslam::viewer
