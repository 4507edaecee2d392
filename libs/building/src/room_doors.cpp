#include "room_doors.h"

#include <algorithm>
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

std::pair<cv::Point, cv::Point> farthest(const std::vector<cv::Point>& cells) {
  std::pair<cv::Point, cv::Point> ends{cells.front(), cells.front()};
  int most = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = i + 1; j < cells.size(); ++j) {
      const cv::Point way = cells[j] - cells[i];
      if (way.dot(way) <= most) continue;
      most = way.dot(way);
      ends = {cells[i], cells[j]};
    }
  }
  return ends;
}

}  // namespace

std::vector<RegionBorder> bordersOf(const FloorRegions& regions) {
  std::vector<RegionBorder> borders;
  for (const auto& [pair, cells] : touchingCells(regions.ids)) {
    for (const auto& group : hangingTogether(cells, regions.ids.size())) {
      const auto [from, to] = farthest(group);
      float halfWidth = 0.0F;
      for (const auto& cell : group) halfWidth = std::max(halfWidth, regions.distance.at<float>(cell));
      borders.push_back({pair.first, pair.second, group, from, to, halfWidth});
    }
  }
  return borders;
}

}  // namespace wardslam::building
