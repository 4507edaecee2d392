#include "wardslam/evaluation/error_statistics.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace wardslam::evaluation {

ErrorStatistics summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  const Eigen::Map<const Eigen::ArrayXd> values(errors.data(), static_cast<Eigen::Index>(errors.size()));

  ErrorStatistics statistics;
  statistics.samples = errors.size();
  statistics.rmse = std::sqrt(values.square().mean());
  statistics.mean = values.mean();
  statistics.median = (errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]) / 2.0;
  statistics.std = std::sqrt((values - statistics.mean).square().mean());
  statistics.min = errors.front();
  statistics.max = errors.back();
  return statistics;
}

}  // namespace wardslam::evaluation
