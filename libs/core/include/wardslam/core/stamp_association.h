#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace wardslam::core {

/// How far apart in time two things may be to belong together, as in the TUM RGB-D benchmark.
inline constexpr double kMaxStampDifference_s = 0.02;

/// Pairs of indices (i, j) with |a[i] − b[j]| < `maxDifference_s`, one-to-one, in order of i: of all such pairs the
/// closest is taken first (ties: smaller i, then j), as associate.py of the TUM RGB-D benchmark does. Both lists must
/// be in order of time.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> associateByStamp(
    const std::vector<double>& a_s, const std::vector<double>& b_s, double maxDifference_s = kMaxStampDifference_s);

}  // namespace wardslam::core
