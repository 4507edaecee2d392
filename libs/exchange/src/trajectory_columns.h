#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wardslam::exchange {

/// Which columns of a list of poses hold what; for KITTI's 12 numbers (a 3x4 matrix, row by row) none is a stamp.
struct TrajectoryColumns {
  std::size_t count = 8;
  std::optional<std::size_t> stamp = 0;
  std::array<std::size_t, 3> position = {1, 2, 3};        ///< x y z
  std::array<std::size_t, 4> orientation = {4, 5, 6, 7};  ///< x y z w
  bool isMatrix = false;
};

/// As a line of headings says; nothing where it does not name all eight. Names as EuRoC ("p_RS_R_x [m]", "q_RS_w []"),
/// evo, RTAB-Map and others write them.
[[nodiscard]] std::optional<TrajectoryColumns> columnsByHeadings(const std::string& headings);

/// As the numbers of the first line tell, where there are no headings: 8 as in the TUM benchmark, 12 as KITTI's, 9 with
/// a number of the pose in front or behind. Nothing where they tell nothing.
[[nodiscard]] std::optional<TrajectoryColumns> columnsByNumbers(const std::vector<double>& row);

}  // namespace wardslam::exchange
