#include "floor_regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace wardslam::building {
namespace {

constexpr float kNarrow = 0.75F;  // of what the smaller of two regions has room for

using Cell = int;  // row · columns + column

/// From the middles of cells to the edges of those that are walls; negative within walls.
cv::Mat distanceToWalls(const cv::Mat& floor) {
  cv::Mat bordered;
  cv::copyMakeBorder(floor, bordered, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat distance;
  cv::distanceTransform(bordered, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return distance(cv::Rect(1, 1, floor.cols, floor.rows)) - 0.5;
}

/// Regions grow from the places farthest from walls towards these; where two meet they become one, or stay two with a
/// narrow place between them.
class RegionsGrowing {
 public:
  RegionsGrowing(const cv::Mat& distance, double widestDoor)
      : distance_(distance), widestHalf_(static_cast<float>(widestDoor / 2.0)), regionOf_(distance.total(), -1) {
    for (const Cell cell : byDistance()) grow(cell);
  }

  /// Regions too small to be rooms become part of the neighbour to which there is most room, if there is one.
  void joinSmall(double smallestRegion) {
    for (bool joined = true; joined;) joined = joinSmallest(smallestRegion);
  }

  [[nodiscard]] FloorRegions result(double smallestRegion) {
    FloorRegions regions;
    regions.distance = distance_;
    regions.ids = cv::Mat(distance_.size(), CV_32SC1, cv::Scalar(0));
    const auto ids = numbers(smallestRegion, regions.middles);
    for (std::size_t cell = 0; cell < regionOf_.size(); ++cell) {
      if (regionOf_[cell] < 0) continue;
      const auto id = ids.find(root(regionOf_[cell]));
      if (id != ids.end()) regions.ids.ptr<int>()[cell] = id->second;
    }
    return regions;
  }

 private:
  struct Region {
    int parent = 0;  ///< Itself, or the one it has become part of.
    Cell peak = 0;
    double size = 0.0;
    std::map<int, float> passages;  ///< To which other region, and how far from walls its widest place is.
  };

  [[nodiscard]] float distanceAt(Cell cell) const { return distance_.ptr<float>()[cell]; }
  [[nodiscard]] float peakOf(int region) const { return distanceAt(regions_[static_cast<std::size_t>(region)].peak); }
  [[nodiscard]] Region& at(int region) { return regions_[static_cast<std::size_t>(region)]; }

  [[nodiscard]] std::vector<Cell> byDistance() const {
    std::vector<Cell> cells(distance_.total());
    std::iota(cells.begin(), cells.end(), 0);
    cells.erase(std::remove_if(cells.begin(), cells.end(), [this](Cell cell) { return distanceAt(cell) <= 0.0F; }),
                cells.end());
    std::stable_sort(cells.begin(), cells.end(), [this](Cell a, Cell b) { return distanceAt(a) > distanceAt(b); });
    return cells;
  }

  int root(int region) {
    while (at(region).parent != region) region = at(region).parent = at(at(region).parent).parent;
    return region;
  }

  /// Of the eight cells around it, that of the cell with the largest distance first.
  std::vector<int> regionsAround(Cell cell) {
    const int row = cell / distance_.cols;
    const int column = cell % distance_.cols;
    std::vector<std::pair<float, int>> around;
    for (int r = std::max(0, row - 1); r <= std::min(distance_.rows - 1, row + 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(distance_.cols - 1, column + 1); ++c) {
        const int region = regionOf_[static_cast<std::size_t>(r * distance_.cols + c)];
        if (region >= 0) around.emplace_back(distance_.at<float>(r, c), root(region));
      }
    }
    std::stable_sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<int> regions;
    for (const auto& [distance, region] : around) {
      if (std::find(regions.begin(), regions.end(), region) == regions.end()) regions.push_back(region);
    }
    return regions;
  }

  void grow(Cell cell) {
    const auto around = regionsAround(cell);
    if (around.empty()) {
      const int region = static_cast<int>(regions_.size());
      regions_.push_back({region, cell, 1.0, {}});
      regionOf_[static_cast<std::size_t>(cell)] = region;
      return;
    }
    regionOf_[static_cast<std::size_t>(cell)] = around.front();
    at(around.front()).size += 1.0;
    for (std::size_t i = 1; i < around.size(); ++i) meet(root(around.front()), root(around[i]), distanceAt(cell));
  }

  void meet(int region, int other, float distance) {
    if (region == other) return;
    const float smallerPeak = std::min(peakOf(region), peakOf(other));
    if (distance >= widestHalf_ || distance >= kNarrow * smallerPeak) {
      join(region, other);
    } else if (at(region).passages.count(other) == 0) {
      at(region).passages[other] = distance;
      at(other).passages[region] = distance;
    }
  }

  /// The one with the lower peak becomes part of the one with the higher peak.
  void join(int region, int other) {
    if (peakOf(other) > peakOf(region)) std::swap(region, other);
    at(other).parent = region;
    at(region).size += at(other).size;
    at(region).passages.erase(other);
    for (const auto& [third, distance] : at(other).passages) {
      at(third).passages.erase(other);
      if (third == region) continue;
      auto& widest = at(region).passages[third];
      widest = std::max(widest, distance);
      at(third).passages[region] = widest;
    }
  }

  bool joinSmallest(double smallestRegion) {
    for (int region = 0; region < static_cast<int>(regions_.size()); ++region) {
      if (at(region).parent != region || at(region).size >= smallestRegion || at(region).passages.empty()) continue;
      const auto& passages = at(region).passages;
      join(region, std::max_element(passages.begin(), passages.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first);
      return true;
    }
    return false;
  }

  /// Numbers of the regions that are large enough, in the order of the rows of their middles.
  std::map<int, int> numbers(double smallestRegion, std::vector<cv::Point>& middles) {
    std::map<Cell, int> byMiddle;
    for (int region = 0; region < static_cast<int>(regions_.size()); ++region) {
      if (at(region).parent == region && at(region).size >= smallestRegion) byMiddle[at(region).peak] = region;
    }
    std::map<int, int> ids;
    for (const auto& [middle, region] : byMiddle) {
      middles.emplace_back(middle % distance_.cols, middle / distance_.cols);
      ids[region] = static_cast<int>(middles.size());
    }
    return ids;
  }

  cv::Mat distance_;
  float widestHalf_;
  std::vector<int> regionOf_;  ///< By cell; -1 = none yet.
  std::vector<Region> regions_;
};

}  // namespace

FloorRegions cutAtNarrowPlaces(const cv::Mat& floor, const RegionOptions& options) {
  RegionsGrowing regions(distanceToWalls(floor), options.widestDoor);
  regions.joinSmall(options.smallestRegion);
  return regions.result(options.smallestRegion);
}

}  // namespace wardslam::building
