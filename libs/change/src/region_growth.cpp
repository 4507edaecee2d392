#include "region_growth.h"

#include <algorithm>
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
    constexpr double kDiagonal = 1.4142135623730951;
    constexpr std::array<Step, 8> kAround = {{{1, 0, 1.0},
                                              {-1, 0, 1.0},
                                              {0, 1, 1.0},
                                              {0, -1, 1.0},
                                              {1, 1, kDiagonal},
                                              {1, -1, kDiagonal},
                                              {-1, 1, kDiagonal},
                                              {-1, -1, kDiagonal}}};
    while (!open_.empty()) {
      const Walk walk = open_.top();
      open_.pop();
      if (walk.length_m > length_m_.at<double>(walk.cell)) continue;  // a shorter one was here
      for (const Step& around : kAround) {
        if (const auto next = step(walk, around)) reach(*next);
      }
    }
    return moves_;
  }

 private:
  struct Step {
    int dx;
    int dy;
    double cells;  ///< How far that is.
  };

  [[nodiscard]] std::optional<Walk> step(const Walk& from, const Step& around) const {
    const cv::Point cell = from.cell + cv::Point(around.dx, around.dy);
    if (!cv::Rect({}, depth_m_.size()).contains(cell)) return std::nullopt;
    const double width_m = cellWidth_ * from.depth_m;
    const double side_m = width_m * around.cells;
    const auto depth = static_cast<double>(depth_m_.at<float>(cell));
    if (depth <= 0) return within({from.length_m + 2 * side_m, cell, from.depth_m, from.moves});
    const double jump_m = std::abs(depth - from.depth_m);
    if (jump_m > 0.05 + 2 * width_m) return std::nullopt;
    return within({from.length_m + std::sqrt(side_m * side_m + jump_m * jump_m), cell, depth, from.moves});
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
  const bool anyMoves = std::any_of(seeds.begin(), seeds.end(), [](const Seed& seed) { return seed.moves; });
  if (!anyMoves) return cv::Mat::zeros(depth_m.size(), CV_8UC1);
  Growth growth(depth_m, cellWidth, reach_m);
  for (const Seed& seed : seeds) growth.plant(seed);
  return growth.grow();
}

}  // namespace wardslam::change
