#include "room_doors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace wardslam::building {
namespace {

using Pair = std::pair<int, int>;  // of ids, the smaller one first

/// The cells of each pair's smaller region that have the other one beside them.
std::map<Pair, std::vector<cv::Point>> touchingCells(const cv::Mat& ids) {
  std::map<Pair, std::vector<cv::Point>> touching;
  const auto look = [&](cv::Point a, cv::Point b) {
    int idA = ids.at<int>(a);
    int idB = ids.at<int>(b);
    if (idA == 0 || idB == 0 || idA == idB) return;
    if (idA > idB) {
      std::swap(idA, idB);
      std::swap(a, b);
    }
    touching[{idA, idB}].push_back(a);
  };
  for (int row = 0; row < ids.rows; ++row) {
    for (int column = 0; column < ids.cols; ++column) {
      if (column + 1 < ids.cols) look({column, row}, {column + 1, row});
      if (row + 1 < ids.rows) look({column, row}, {column, row + 1});
    }
  }
  return touching;
}

/// Cells that hang together, eight around each.
std::vector<std::vector<cv::Point>> hangingTogether(const std::vector<cv::Point>& cells, cv::Size size) {
  cv::Mat mask(size, CV_8UC1, cv::Scalar(0));
  for (const auto& cell : cells) mask.at<unsigned char>(cell) = 255;
  cv::Mat parts;
  std::vector<std::vector<cv::Point>> groups(static_cast<std::size_t>(cv::connectedComponents(mask, parts, 8)) - 1);
  for (const auto& cell : cells) groups[static_cast<std::size_t>(parts.at<int>(cell) - 1)].push_back(cell);
  return groups;
}

bool isFloor(const FloorRegions& regions, const cv::Point& cell) {
  return cv::Rect({}, regions.ids.size()).contains(cell) && regions.distance.at<float>(cell) > 0.0F;
}

/// The last floor from there in a direction.
cv::Point edgeFrom(const FloorRegions& regions, const cv::Point& middle, const cv::Point2d& direction) {
  cv::Point edge = middle;
  for (double way = 0.5;; way += 0.5) {
    const cv::Point next(cvRound(middle.x + way * direction.x), cvRound(middle.y + way * direction.y));
    if (!isFloor(regions, next)) return edge;
    edge = next;
  }
}

/// The shortest line through a place from wall to wall.
std::pair<cv::Point, cv::Point> shortestAcross(const FloorRegions& regions, const cv::Point& middle) {
  constexpr int kDirections = 36;
  std::pair<cv::Point, cv::Point> shortest{middle, middle};
  int least = std::numeric_limits<int>::max();
  for (int i = 0; i < kDirections; ++i) {
    const double angle_rad = CV_PI * i / kDirections;
    const cv::Point2d direction(std::cos(angle_rad), std::sin(angle_rad));
    const cv::Point from = edgeFrom(regions, middle, -direction);
    const cv::Point to = edgeFrom(regions, middle, direction);
    const cv::Point way = to - from;
    if (way.dot(way) >= least) continue;
    least = way.dot(way);
    shortest = {from, to};
  }
  return shortest;
}

}  // namespace

std::vector<RegionBorder> bordersOf(const FloorRegions& regions) {
  std::vector<RegionBorder> borders;
  for (const auto& [pair, cells] : touchingCells(regions.ids)) {
    for (const auto& group : hangingTogether(cells, regions.ids.size())) {
      const auto isNarrower = [&](const cv::Point& one, const cv::Point& another) {
        return regions.distance.at<float>(one) < regions.distance.at<float>(another);
      };
      const cv::Point middle = *std::max_element(group.begin(), group.end(), isNarrower);
      const auto [from, to] = shortestAcross(regions, middle);
      borders.push_back({pair.first, pair.second, group, from, to, regions.distance.at<float>(middle)});
    }
  }
  return borders;
}

}  // namespace wardslam::building
