#include "even_spread.h"

#include <algorithm>
#include <tuple>

namespace wardslam::features {
namespace {

bool isStronger(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::make_tuple(-a.response, a.pt.y, a.pt.x) < std::make_tuple(-b.response, b.pt.y, b.pt.x);
}

/// How many stronger ones there are in the cell of each.
std::vector<std::size_t> turnsOf(const std::vector<cv::KeyPoint>& strongestFirst, int cellSize_px) {
  const auto cell = [&](float at_px) {
    return static_cast<std::size_t>(at_px) / static_cast<std::size_t>(cellSize_px);
  };
  std::size_t columns = 1;
  std::size_t rows = 1;
  for (const cv::KeyPoint& keypoint : strongestFirst) {
    columns = std::max(columns, cell(keypoint.pt.x) + 1);
    rows = std::max(rows, cell(keypoint.pt.y) + 1);
  }
  std::vector<std::size_t> taken(columns * rows, 0);
  std::vector<std::size_t> turns;
  turns.reserve(strongestFirst.size());
  for (const cv::KeyPoint& keypoint : strongestFirst) {
    turns.push_back(taken[cell(keypoint.pt.y) * columns + cell(keypoint.pt.x)]++);
  }
  return turns;
}

}  // namespace

std::vector<cv::KeyPoint> spreadEvenly(std::vector<cv::KeyPoint> keypoints, std::size_t count, int cellSize_px) {
  std::sort(keypoints.begin(), keypoints.end(), isStronger);
  const std::vector<std::size_t> turns = turnsOf(keypoints, cellSize_px);
  std::vector<std::vector<std::size_t>> byTurn;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    byTurn.resize(std::max(byTurn.size(), turns[i] + 1));
    byTurn[turns[i]].push_back(i);
  }
  std::vector<cv::KeyPoint> spread;
  spread.reserve(std::min(count, keypoints.size()));
  for (const auto& turn : byTurn) {
    for (const std::size_t i : turn) {
      if (spread.size() == count) return spread;
      spread.push_back(keypoints[i]);
    }
  }
  return spread;
}

}  // namespace wardslam::features
