#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::mapping {

/// The floor of one storey as a surface: where keyframes saw it, and as far as the cloud goes on from there no steeper
/// than a ramp. So a map that leans has its floor where it was seen, a ramp belongs to it, and stairs do not. Where
/// nothing is known of it, it is as high as nearby. A map whose keyframes saw no ground has it at z = 0.
class GroundSurface {
 public:
  explicit GroundSurface(const SemanticMap& map);

  /// Whether a keyframe stands on it; others are on storeys above or beneath.
  [[nodiscard]] bool carries(std::uint64_t keyframe) const { return carried_.count(keyframe) != 0; }

  [[nodiscard]] double heightOver_m(const Eigen::Vector3f& p_map_m) const;

 private:
  struct Foot {
    Eigen::Vector3d p_level_m;     ///< Under the camera.
    Eigen::Vector3d normal_level;  ///< Of the ground there.
    bool isSeen = false;           ///< Else it is that of the nearest keyframe that saw one.
  };
  struct Cell {
    float height_m = 0.0F;
    bool isKnown = false;
    std::int32_t parent = -1;  ///< Where it goes on from.
  };

  void stand(const SemanticMap& map);
  void chooseStorey();
  void makeCells(const SemanticMap& map);
  void countPoints(const SemanticMap& map);
  std::vector<std::int32_t> seed(const SemanticMap& map);
  void spread(std::vector<std::int32_t> edge);
  void fill();
  [[nodiscard]] bool isWithin(const Eigen::Vector2d& p_level_m) const;
  [[nodiscard]] std::int32_t indexOf(const Eigen::Vector2d& p_level_m) const;
  [[nodiscard]] std::vector<std::int32_t> neighbours(std::int32_t cell) const;
  [[nodiscard]] bool support(std::int32_t cell, double expected_m, double tolerance_m, double& height_m) const;
  [[nodiscard]] bool isNoSteeperThanARamp(std::int32_t from, double height_m) const;

  Eigen::Matrix3d R_level_map_ = Eigen::Matrix3d::Identity();
  std::map<std::uint64_t, Foot> feet_;
  std::set<std::uint64_t> carried_;
  bool isSeen_ = false;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  double lowest_m_ = 0.0;  ///< Of the points that are counted.
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::int32_t layers_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::uint16_t> counts_;  ///< Of points, by cell and height.
};

}  // namespace wardslam::mapping
