#include "region_growth.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

namespace wardslam::change {
namespace {

/// A walk along the surface from a seed to a cell.
struct Walk {
  double length_m;
  cv::Point cell;
  double depth_m;  ///< Of the cell, or of the last one that had any.
  bool moves;

  bool operator>(const Walk& other) const { return length_m > other.length_m; }
};

/// Dijkstra's shortest ways from all seeds at once.
class Growth {
 public:
  Growth(const cv::Mat& depth_m, double cellWidth, double reach_m)
      : depth_m_(depth_m),
        cellWidth_(cellWidth),
        reach_m_(reach_m),
        length_m_(depth_m.size(), CV_64FC1, cv::Scalar(std::numeric_limits<double>::infinity())),
        moves_(depth_m.size(), CV_8UC1, cv::Scalar(0)) {}

  void plant(const Seed& seed) {
    const auto depth = static_cast<double>(depth_m_.at<float>(seed.cell));
    if (depth > 0) reach({seed.handicap_m, seed.cell, depth, seed.moves});
  }

  cv::Mat grow() {
    constexpr std::array<std::array<int, 2>, 8> kAround = {
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
    while (!open_.empty()) {
      const Walk walk = open_.top();
      open_.pop();
      if (walk.length_m > length_m_.at<double>(walk.cell)) continue;  // a shorter one was here
      for (const auto& [dx, dy] : kAround) {
        if (const auto next = step(walk, dx, dy)) reach(*next);
      }
    }
    return moves_;
  }

 private:
  [[nodiscard]] std::optional<Walk> step(const Walk& from, int dx, int dy) const {
    const cv::Point cell = from.cell + cv::Point(dx, dy);
    if (!cv::Rect({}, depth_m_.size()).contains(cell)) return std::nullopt;
    const double width_m = cellWidth_ * from.depth_m;
    const double side_m = width_m * std::hypot(dx, dy);
    const auto depth = static_cast<double>(depth_m_.at<float>(cell));
    if (depth <= 0) return within({from.length_m + 2 * side_m, cell, from.depth_m, from.moves});
    const double jump_m = std::abs(depth - from.depth_m);
    if (jump_m > 0.05 + 2 * width_m) return std::nullopt;
    return within({from.length_m + std::hypot(side_m, jump_m), cell, depth, from.moves});
  }

  [[nodiscard]] std::optional<Walk> within(const Walk& walk) const {
    return walk.length_m <= reach_m_ ? std::optional(walk) : std::nullopt;
  }

  void reach(const Walk& walk) {
    double& shortest = length_m_.at<double>(walk.cell);
    if (walk.length_m >= shortest) return;
    shortest = walk.length_m;
    moves_.at<std::uint8_t>(walk.cell) = walk.moves ? 255 : 0;
    open_.push(walk);
  }

  const cv::Mat& depth_m_;
  double cellWidth_;
  double reach_m_;
  cv::Mat length_m_;
  cv::Mat moves_;
  std::priority_queue<Walk, std::vector<Walk>, std::greater<>> open_;
};

}  // namespace

cv::Mat growRegions(const cv::Mat& depth_m, double cellWidth, const std::vector<Seed>& seeds, double reach_m) {
  Growth growth(depth_m, cellWidth, reach_m);
  for (const Seed& seed : seeds) growth.plant(seed);
  return growth.grow();
}

}  // namespace wardslam::change
