#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace wardslam::synth {

/// A round along a closed polygon with rounded corners.
class ClosedRoute {
 public:
  struct Place {
    Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
    double heading_rad = 0.0;  ///< Of the way, eased over kEasing_m; continuous along a round.
  };

  /// Begins in the middle of the last side, towards the first corner. Throws std::invalid_argument when a side is too
  /// short for its corners.
  ClosedRoute(const std::vector<Eigen::Vector2d>& corners_m, double radius_m);
  /// The same with a radius of its own for each corner.
  ClosedRoute(const std::vector<Eigen::Vector2d>& corners_m, const std::vector<double>& radii_m);

  [[nodiscard]] double length_m() const { return static_cast<double>(places_.size()) * step_m_; }

  /// `s_m` along the way, any number of rounds.
  [[nodiscard]] Place at(double s_m) const;

  static constexpr double kEasing_m = 1.8;  ///< A turn begins before its corner and ends behind it.

 private:
  double step_m_ = 0.01;
  double turn_rad_ = 0.0;  ///< Of a whole round.
  std::vector<Place> places_;
};

}  // namespace wardslam::synth
