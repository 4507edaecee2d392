#pragma once

#include <cmath>
#include <random>

/// The standard's distributions differ from library to library; these do not.
namespace wardslam::nav_demo {

[[nodiscard]] inline double uniform(std::mt19937& random, double from, double to) {
  return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
}

/// Mean 0 (Box and Muller).
[[nodiscard]] inline double gaussian(std::mt19937& random, double sigma) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(random, 0.0, 1.0)));
  return sigma * radius * std::cos(uniform(random, 0.0, 2.0 * M_PI));
}

}  // namespace wardslam::nav_demo
