#pragma once

namespace wardslam::core {

/// How the standard deviation of a measured depth grows with the depth: σ_z = least + growth (z − from)².
///
/// The default is a Kinect's axial noise (Nguyen, Izadi, Lovell: "Modeling Kinect sensor noise for improved 3D
/// reconstruction and tracking", 3DIMPVT 2012).
struct DepthNoise {
  double least_m = 0.0012;
  double growth_per_m = 0.0019;
  double from_m = 0.4;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);

  [[nodiscard]] constexpr double sigma_m(double z_m) const {
    return least_m + growth_per_m * (z_m - from_m) * (z_m - from_m);
  }

  [[nodiscard]] constexpr bool operator==(const DepthNoise& other) const {
    return least_m == other.least_m && growth_per_m == other.growth_per_m && from_m == other.from_m;
  }
};

template <class Self, class Visitor>
void DepthNoise::describe(Self& self, Visitor& visit) {
  visit("least", self.least_m, {1e-5, 1.0}, "m", "standard deviation of the depth where it is smallest");
  visit("growth", self.growth_per_m, {0.0, 1.0}, "1/m",
        "what it grows by, times the square of the distance from there");
  visit("from", self.from_m, {0.0, 10.0}, "m", "depth where it is smallest");
}

}  // namespace wardslam::core
