#include "wardslam/change/moving_regions.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "free_space.h"
#include "point_tracker.h"
#include "region_growth.h"
#include "wardslam/change/scene_motion.h"

namespace wardslam::change {
namespace {

constexpr int kCell_px = 2 * DepthGrid::kStep_px;
constexpr double kRests = -0.5;  // log-odds below which a point counts as seen at rest

/// Nearest of the depths in a cell: at an edge the thing in front is what may move.
cv::Mat cellDepth(const cv::Mat& depth_m) {
  cv::Mat cells(depth_m.rows / 2, depth_m.cols / 2, CV_32FC1, cv::Scalar(0));
  for (int row = 0; row < 2 * cells.rows; ++row) {
    for (int column = 0; column < 2 * cells.cols; ++column) {
      const float depth = depth_m.at<float>(row, column);
      float& cell = cells.at<float>(row / 2, column / 2);
      if (depth > 0 && (cell <= 0 || depth < cell)) cell = depth;
    }
  }
  return cells;
}

cv::Point cellOf(const cv::Point2f& raw_px, const cv::Size& cells) {
  return {std::min(static_cast<int>(raw_px.x) / kCell_px, cells.width - 1),
          std::min(static_cast<int>(raw_px.y) / kCell_px, cells.height - 1)};
}

cv::Mat cellsThatAre(Seen kind, const cv::Mat& space, const cv::Size& cells) {
  cv::Mat is = space == static_cast<int>(kind);
  cv::resize(is, is, cells, 0, 0, cv::INTER_AREA);
  return is >= 128;
}

/// Removes what is narrower than two pixels. (cv::MORPH_OPEN with an even kernel would move what stays by a pixel.)
void openByPairs(cv::Mat& mask) {
  const cv::Mat pair = cv::getStructuringElement(cv::MORPH_RECT, {2, 2});
  cv::erode(mask, mask, pair, {1, 1});
  cv::dilate(mask, mask, pair, {0, 0});
}

/// Surfaces that came, as cells: connected pieces of at least the area asked for.
cv::Mat appearedCells(const SceneMotion& motion, const cv::Mat& depth_m, double cellWidth, double minArea_m2) {
  cv::Mat appeared = motion.space() == static_cast<int>(Seen::Through);
  openByPairs(appeared);
  cv::Mat cells;
  cv::resize(appeared, cells, depth_m.size(), 0, 0, cv::INTER_AREA);
  cells = cells >= 128;
  cv::Mat pieces;
  const int count = cv::connectedComponents(cells, pieces, 8, CV_32S);
  std::vector<double> area_m2(static_cast<std::size_t>(count), 0.0);
  const auto forEach = [&](auto&& visit) {
    for (int row = 0; row < cells.rows; ++row) {
      for (int column = 0; column < cells.cols; ++column) {
        if (const int piece = pieces.at<int>(row, column))
          visit(cv::Point(column, row), static_cast<std::size_t>(piece));
      }
    }
  };
  forEach([&](cv::Point cell, std::size_t piece) {
    area_m2[piece] += std::pow(cellWidth * static_cast<double>(depth_m.at<float>(cell)), 2);
  });
  forEach([&](cv::Point cell, std::size_t piece) {
    if (area_m2[piece] < minArea_m2) cells.at<std::uint8_t>(cell) = 0;
  });
  return cells;
}

struct PlacedTrack {
  cv::Point cell;
  Eigen::Vector3d p_m;
  double logOdds;
};

std::vector<PlacedTrack> placedTracks(const SceneMotion& motion, const core::CameraModel& camera,
                                      const cv::Mat& depth_m) {
  std::vector<PlacedTrack> placed;
  for (const Track& track : motion.tracks()) {
    const cv::Point cell = cellOf(track.raw_px, depth_m.size());
    const TrackedPosition& last = track.positions.back();
    const double depth = last.hasDepth() ? last.depth.clear_m : static_cast<double>(depth_m.at<float>(cell));
    if (depth > 0) placed.push_back({cell, camera.unproject(last.undistorted_px, depth), track.logOdds});
  }
  return placed;
}

/// What the tracks within a hand's breadth or two say on average, itself among them.
struct Neighbourhood {
  double logOdds = 0.0;
  int moving = 0;  ///< How many of them move.
};

Neighbourhood around(const PlacedTrack& track, const std::vector<PlacedTrack>& all, double strict) {
  constexpr double kSigma_m = 0.1;
  Neighbourhood result;
  double weights = 0;
  for (const PlacedTrack& other : all) {
    const double distance = (other.p_m - track.p_m).squaredNorm() / (2 * kSigma_m * kSigma_m);
    if (distance > 4.5) continue;
    const double weight = std::exp(-distance);
    result.logOdds += weight * other.logOdds;
    weights += weight;
    if (other.logOdds > strict) ++result.moving;
  }
  result.logOdds /= weights;
  return result;
}

/// Where growth starts, of what moves and of what rests; of what moves, nothing in explained cells.
std::vector<Seed> seedsOf(const std::vector<PlacedTrack>& tracks, const cv::Mat& appeared, const cv::Mat& same,
                          const cv::Mat& explained, const MovingRegionsOptions& options) {
  constexpr int kWitnesses = 3;
  const double mayBeInterior_m = options.reach_m / 2;  // a slow thing's inside looks as it did before
  const auto isExplained = [&explained](cv::Point cell) { return explained.at<std::uint8_t>(cell) != 0; };
  std::vector<Seed> seeds;
  for (const PlacedTrack& track : tracks) {
    const auto [logOdds, moving] = around(track, tracks, options.strict_log_odds);
    const bool hasCome = appeared.at<std::uint8_t>(track.cell) != 0;
    const bool isBorneOut = hasCome || moving >= kWitnesses;
    if (logOdds > options.strict_log_odds && track.logOdds > 0 && isBorneOut && !isExplained(track.cell)) {
      seeds.push_back({track.cell, true});
    }
    if (logOdds < kRests && !hasCome) seeds.push_back({track.cell, false});
  }
  for (int row = 0; row < appeared.rows; ++row) {
    for (int column = 0; column < appeared.cols; ++column) {
      const cv::Point cell(column, row);
      if (appeared.at<std::uint8_t>(cell) != 0 && !isExplained(cell)) seeds.push_back({cell, true});
      if (same.at<std::uint8_t>(cell) != 0) seeds.push_back({cell, false, mayBeInterior_m});
    }
  }
  return seeds;
}

/// Growth fills holes in the depth; what was seen at rest in them, out of the sensor's range mostly, is no part of the
/// mover.
void giveBackHoles(cv::Mat& moves, const SceneMotion& motion, const cv::Mat& depth_m) {
  for (const Track& track : motion.tracks()) {
    const cv::Point cell = cellOf(track.raw_px, depth_m.size());
    if (track.logOdds < kRests && depth_m.at<float>(cell) <= 0) moves.at<std::uint8_t>(cell) = 0;
  }
}

}  // namespace

cv::Mat movingRegions(const SceneMotion& motion, const core::CameraModel& camera, const cv::Mat& explained,
                      const MovingRegionsOptions& options) {
  const cv::Mat depth_m = cellDepth(motion.grid().depth_m());
  const double cellWidth = kCell_px / camera.fx_px;
  const cv::Mat appeared = appearedCells(motion, depth_m, cellWidth, options.min_area_m2);
  const cv::Mat same = cellsThatAre(Seen::Same, motion.space(), depth_m.size());
  cv::Mat explainedCells;
  cv::resize(explained, explainedCells, depth_m.size(), 0, 0, cv::INTER_NEAREST);
  const auto tracks = placedTracks(motion, camera, depth_m);
  const auto seeds = seedsOf(tracks, appeared, same, explainedCells, options);
  cv::Mat moves = growRegions(depth_m, cellWidth, seeds, options.reach_m);
  giveBackHoles(moves, motion, depth_m);
  cv::Mat regions;
  cv::resize(moves, regions, explained.size(), 0, 0, cv::INTER_NEAREST);
  for (const Track& track : motion.tracks()) {
    const bool isExplained = explainedCells.at<std::uint8_t>(cellOf(track.raw_px, depth_m.size())) != 0;
    if (track.logOdds <= options.loose_log_odds || isExplained) continue;
    cv::circle(regions, track.raw_px, kCell_px / 2, 255, cv::FILLED);
  }
  return regions;
}

}  // namespace wardslam::change
