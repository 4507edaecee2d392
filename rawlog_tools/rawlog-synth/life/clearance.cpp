#include "life/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace wardslam::synth {
namespace {

constexpr double kCell_m = 0.05;
constexpr double kBorder_m = 0.5;
constexpr float kShin_m = 0.12F;
constexpr float kHead_m = 1.85F;

bool isInTheWay(const Vertex* corner) {
  const auto [low, high] = std::minmax({corner[0].p_m.z(), corner[1].p_m.z(), corner[2].p_m.z()});
  return high > kShin_m && low < kHead_m;
}

Eigen::Vector2d onFloor(const Vertex& vertex) { return vertex.p_m.head<2>().cast<double>(); }

template <class Use>
void forTriangles(const std::vector<Thing>& things, const std::vector<bool>& counts, Use use) {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (!counts.empty() && !counts[i]) continue;
    for (const Surface& surface : things[i].surfaces) {
      const auto& vertices = surface.mesh.vertices;
      for (std::size_t k = 0; k + 2 < vertices.size(); k += 3) {
        if (isInTheWay(&vertices[k])) use(&vertices[k]);
      }
    }
  }
}

}  // namespace

ClearanceMap::ClearanceMap(const std::vector<Thing>& things, const std::vector<bool>& counts) {
  Eigen::AlignedBox2d box_m;
  forTriangles(things, counts, [&](const Vertex* corner) {
    for (int i = 0; i < 3; ++i) box_m.extend(onFloor(corner[i]));
  });
  open(box_m);
  forTriangles(things, counts, [&](const Vertex* corner) {
    std::array<cv::Point, 3> cells;
    for (std::size_t i = 0; i < 3; ++i) cells[i] = cell(onFloor(corner[i]));
    cv::fillConvexPoly(distance_m_, cells.data(), 3, cv::Scalar(0));
    for (std::size_t i = 0; i < 3; ++i) cv::line(distance_m_, cells[i], cells[(i + 1) % 3], cv::Scalar(0));
  });
  measure();
}

ClearanceMap::ClearanceMap(const std::vector<Eigen::Vector2d>& points_m) {
  Eigen::AlignedBox2d box_m;
  for (const Eigen::Vector2d& p : points_m) box_m.extend(p);
  if (!box_m.isEmpty()) box_m = {box_m.min().array() - kFar_m, box_m.max().array() + kFar_m};
  open(box_m);
  for (const Eigen::Vector2d& p : points_m) distance_m_.at<std::uint8_t>(cv::Point(cell(p))) = 0;
  measure();
}

void ClearanceMap::open(const Eigen::AlignedBox2d& box_m) {
  if (box_m.isEmpty()) {
    distance_m_ = cv::Mat(1, 1, CV_8UC1, cv::Scalar(255));
    return;
  }
  origin_m_ = box_m.min().array() - kBorder_m;
  const Eigen::Vector2d size = ((box_m.sizes().array() + 2 * kBorder_m) / kCell_m).ceil();
  distance_m_ = cv::Mat(static_cast<int>(size.y()), static_cast<int>(size.x()), CV_8UC1, cv::Scalar(255));
}

cv::Point2d ClearanceMap::cell(const Eigen::Vector2d& p_m) const {
  const Eigen::Vector2d index = (p_m - origin_m_) / kCell_m;
  return {std::clamp(std::floor(index.x()), 0.0, distance_m_.cols - 1.0),
          std::clamp(std::floor(index.y()), 0.0, distance_m_.rows - 1.0)};
}

void ClearanceMap::measure() {
  cv::Mat cells;
  if (cv::countNonZero(distance_m_) == static_cast<int>(distance_m_.total())) {
    distance_m_ = cv::Mat(distance_m_.size(), CV_32FC1, cv::Scalar(kFar_m));
    return;
  }
  cv::distanceTransform(distance_m_, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  distance_m_ = cv::min(cells * kCell_m, kFar_m);
}

double ClearanceMap::at(const Eigen::Vector2d& p_m) const {
  return static_cast<double>(distance_m_.at<float>(cv::Point(cell(p_m))));
}

double ClearanceMap::along(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const {
  const int steps = std::max(1, static_cast<int>(std::ceil((b_m - a_m).norm() / kCell_m)));
  double least_m = kFar_m;
  for (int i = 0; i <= steps; ++i) least_m = std::min(least_m, at(a_m + (b_m - a_m) * i / steps));
  return least_m;
}

}  // namespace wardslam::synth
