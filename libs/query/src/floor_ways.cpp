#include "floor_ways.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace wardslam::query {
namespace {

// Lengths in tenths of a cell: whole numbers let buckets take the place of a sorted queue (Dial's algorithm).
constexpr int kStraight = 10;
constexpr int kDiagonal = 14;

int poolingFactor(const mapping::FloorPlan& plan, double smallestCell_m) {
  return std::max(1, static_cast<int>(std::lround(smallestCell_m / plan.resolution_m)));
}

struct Step {
  std::ptrdiff_t offset;  ///< Of the cell's number.
  int length;
};

std::array<Step, 8> stepsOnFloorOf(std::ptrdiff_t columns) {
  return {{{-1, kStraight},
           {1, kStraight},
           {-columns, kStraight},
           {columns, kStraight},
           {-columns - 1, kDiagonal},
           {-columns + 1, kDiagonal},
           {columns - 1, kDiagonal},
           {columns + 1, kDiagonal}}};
}

/// Free where all of the pooled cells are, with a border that is not.
cv::Mat pooledFree(const mapping::FloorPlan& plan, int factor) {
  if (plan.cells.empty()) return cv::Mat(1, 1, CV_8UC1, cv::Scalar(0));
  cv::Mat free = plan.cells == mapping::FloorPlan::kFree;
  const auto missing = [factor](int size) { return (factor - size % factor) % factor; };
  cv::copyMakeBorder(free, free, 0, missing(free.rows), 0, missing(free.cols), cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::erode(free, free, cv::Mat::ones(factor, factor, CV_8UC1), cv::Point(0, 0), 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::resize(free, free, {}, 1.0 / factor, 1.0 / factor, cv::INTER_NEAREST);
  cv::copyMakeBorder(free, free, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  return free;
}

}  // namespace

/// Distances by cell, -1 = not reached. calloc leaves pages nobody touches to the system, so a short walk on a large
/// floor costs little.
class FloorWays::Distances {
 public:
  explicit Distances(std::size_t cells) : plusOne_(static_cast<int*>(std::calloc(cells, sizeof(int))), std::free) {
    if (plusOne_ == nullptr) throw std::bad_alloc();
  }

  [[nodiscard]] int of(std::size_t cell) const { return plusOne_.get()[cell] - 1; }
  void set(std::size_t cell, int distance) { plusOne_.get()[cell] = distance + 1; }

 private:
  std::unique_ptr<int, decltype(&std::free)> plusOne_;
};

FloorWays::FloorWays(const mapping::FloorPlan& plan, double smallestCell_m) {
  const int factor = poolingFactor(plan, smallestCell_m);
  free_ = pooledFree(plan, factor);
  cell_m_ = factor * plan.resolution_m;
  origin_m_ = plan.origin_m - Eigen::Vector2d::Constant(cell_m_);
}

Eigen::Vector2d FloorWays::centre_m(int row, int column) const {
  return origin_m_ + cell_m_ * Eigen::Vector2d(column + 0.5, row + 0.5);
}

void FloorWays::forEachFreeCellNear(const Eigen::AlignedBox2d& box_m, double reach_m,
                                    const std::function<void(Cell)>& take) const {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(reach_m);
  const Eigen::Array2d limit(free_.cols, free_.rows);
  const auto cellOf = [&](const Eigen::Vector2d& p_m) -> Eigen::Array2i {
    return ((p_m - origin_m_) / cell_m_).array().floor().max(0.0).min(limit - 1.0).cast<int>();
  };
  const Eigen::Array2i first = cellOf(box_m.min() - reach);
  const Eigen::Array2i last = cellOf(box_m.max() + reach);
  for (int row = first.y(); row <= last.y(); ++row) {
    for (int column = first.x(); column <= last.x(); ++column) {
      if (free_.at<unsigned char>(row, column) == 0) continue;
      if (box_m.exteriorDistance(centre_m(row, column)) > reach_m) continue;
      take(static_cast<Cell>(row) * static_cast<Cell>(free_.cols) + static_cast<Cell>(column));
    }
  }
}

std::optional<FloorWays::Cell> FloorWays::freeCellNear(const Eigen::Vector2d& p_map_m, double reach_m) const {
  std::optional<Cell> nearest;
  double distance_m = std::numeric_limits<double>::infinity();
  forEachFreeCellNear({p_map_m, p_map_m}, reach_m, [&](Cell cell) {
    const Eigen::Vector2d centre = centre_m(cell);
    if ((centre - p_map_m).norm() >= distance_m) return;
    distance_m = (centre - p_map_m).norm();
    nearest = cell;
  });
  return nearest;
}

std::optional<double> FloorWays::walk(Cell start, const std::function<bool(Cell)>& arrive) const {
  Distances distances(free_.total());
  const auto distance = spread(start, arrive, distances);
  return distance ? std::optional(*distance * cell_m_ / kStraight) : std::nullopt;
}

std::optional<std::vector<Eigen::Vector2d>> FloorWays::wayBetween(Cell start, Cell goal) const {
  Distances distances(free_.total());
  if (!spread(
          start, [&](Cell cell) { return cell == goal; }, distances))
    return std::nullopt;
  const std::vector<Cell> cells = backFrom(goal, distances);
  std::vector<Eigen::Vector2d> corners_m = {centre_m(cells.back())};
  for (auto corner = cells.rbegin(); corner + 1 != cells.rend();) {  // the farthest that is still in sight comes next
    auto next = corner + 1;
    while (next + 1 != cells.rend() && seesEachOther(*corner, *(next + 1))) ++next;
    corners_m.push_back(centre_m(*next));
    corner = next;
  }
  return corners_m;
}

/// Visits cells in order of their distance until `arrive` says true; returns that distance, in tenths of a cell.
std::optional<int> FloorWays::spread(Cell start, const std::function<bool(Cell)>& arrive, Distances& distances) const {
  const auto steps = stepsOnFloorOf(free_.cols);
  const unsigned char* const free = free_.ptr();
  // Cells to visit, by distance: what waits at one time lies less than one diagonal step apart, so few buckets will do.
  std::array<std::vector<Cell>, kDiagonal + 1> buckets;
  distances.set(start, 0);
  buckets[0].push_back(start);
  std::size_t waiting = 1;
  for (int distance = 0; waiting > 0; ++distance) {
    auto& bucket = buckets.at(static_cast<std::size_t>(distance) % buckets.size());
    waiting -= bucket.size();
    for (const Cell cell : bucket) {
      if (distances.of(cell) != distance) continue;  // was reached on a shorter way meanwhile
      if (arrive(cell)) return distance;
      for (const auto& [offset, length] : steps) {
        const auto neighbour = static_cast<Cell>(static_cast<std::ptrdiff_t>(cell) + offset);
        if (free[neighbour] == 0) continue;
        const int known = distances.of(neighbour);
        if (known >= 0 && known <= distance + length) continue;
        distances.set(neighbour, distance + length);
        buckets.at(static_cast<std::size_t>(distance + length) % buckets.size()).push_back(neighbour);
        ++waiting;
      }
    }
    bucket.clear();
  }
  return std::nullopt;
}

/// The cells of the way, the goal first.
std::vector<FloorWays::Cell> FloorWays::backFrom(Cell goal, const Distances& distances) const {
  const auto steps = stepsOnFloorOf(free_.cols);
  std::vector<Cell> cells = {goal};
  for (int left = distances.of(goal); left > 0; left = distances.of(cells.back())) {
    for (const auto& [offset, length] : steps) {
      const auto before = static_cast<Cell>(static_cast<std::ptrdiff_t>(cells.back()) + offset);
      if (distances.of(before) != left - length) continue;
      cells.push_back(before);
      break;
    }
  }
  return cells;
}

/// Whether a straight line between their middles stays on free cells, those it touches at a corner included.
bool FloorWays::seesEachOther(Cell a, Cell b) const {
  cv::LineIterator line(free_, pixelOf(a), pixelOf(b), 4);
  for (int i = 0; i < line.count; ++i, ++line) {
    if (**line == 0) return false;
  }
  return true;
}

cv::Point FloorWays::pixelOf(Cell cell) const {
  const auto columns = static_cast<Cell>(free_.cols);
  return {static_cast<int>(cell % columns), static_cast<int>(cell / columns)};
}

Eigen::Vector2d FloorWays::centre_m(Cell cell) const {
  const cv::Point pixel = pixelOf(cell);
  return centre_m(pixel.y, pixel.x);
}

}  // namespace wardslam::query
