#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>

#include "wardslam/merging/map_merge.h"
#include "wardslam/pipeline/slam_options.h"

namespace wardslam::merging {

/// How one map lies to another.
struct Alignment {
  Eigen::Isometry3d T_a_b =
      Eigen::Isometry3d::Identity();  ///< Takes points of the second map's frame into the first's.
  /// Of a small motion within the first map's frame, after T_a_b: translation (m²), then turning about its axes (rad²).
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  std::size_t looks = 0;      ///< From one map into the other it is the best fit of.
  double misfit_m = 0.0;      ///< Of these, root mean square,
  double misfit_rad = 0.0;    ///< and of their directions.
  bool haveOneFrame = false;  ///< One of the maps is the other, gone on with: nothing had to be found.
};

/// By the places that both maps show; nothing where there are none. Neither is touched. Throws core::InputError.
[[nodiscard]] std::optional<Alignment> align(const std::filesystem::path& a, const std::filesystem::path& b,
                                             const pipeline::SlamOptions& options, const ProgressSink& progress);

}  // namespace wardslam::merging
