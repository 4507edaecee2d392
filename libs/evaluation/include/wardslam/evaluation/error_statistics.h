#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace wardslam::evaluation {

/// Summary of a sample of errors, in the unit of the sample. Of an empty sample every figure is NaN.
struct ErrorStatistics {
  std::size_t samples = 0;
  double rmse = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();
  double median =
      std::numeric_limits<double>::quiet_NaN();           ///< Mean of the two middle ones where their number is even.
  double std = std::numeric_limits<double>::quiet_NaN();  ///< Of the sample itself (divided by n, not n - 1).
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
};

[[nodiscard]] ErrorStatistics summarise(std::vector<double> errors);

}  // namespace wardslam::evaluation
