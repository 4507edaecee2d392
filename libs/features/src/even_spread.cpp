#include "even_spread.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>

namespace wardslam::features {
namespace {

auto cellOf(const cv::KeyPoint& keypoint, int cellSize_px) {
  return std::make_pair(static_cast<int>(keypoint.pt.y) / cellSize_px, static_cast<int>(keypoint.pt.x) / cellSize_px);
}

bool isStronger(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::make_tuple(-a.response, a.pt.y, a.pt.x) < std::make_tuple(-b.response, b.pt.y, b.pt.x);
}

}  // namespace

std::vector<cv::KeyPoint> spreadEvenly(std::vector<cv::KeyPoint> keypoints, std::size_t count, int cellSize_px) {
  std::sort(keypoints.begin(), keypoints.end(), isStronger);
  std::vector<std::size_t> turn(keypoints.size());
  std::map<std::pair<int, int>, std::size_t> turnsTaken;
  for (std::size_t i = 0; i < keypoints.size(); ++i) turn[i] = turnsTaken[cellOf(keypoints[i], cellSize_px)]++;

  std::vector<std::size_t> order(keypoints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return turn[a] < turn[b]; });
  order.resize(std::min(count, order.size()));

  std::vector<cv::KeyPoint> spread;
  spread.reserve(order.size());
  for (const std::size_t i : order) spread.push_back(keypoints[i]);
  return spread;
}

}  // namespace wardslam::features
