#pragma once

namespace wardslam::sources {

/// Section `sources.stereo:` of the configuration: how depth is made of a stereo pair (semi-global matching).
struct StereoOptions {
  double min_range_m = 0.5;
  double max_range_m = 10.0;
  int block_size_px = 5;
  int uniqueness_percent = 10;
  int left_right_check_px = 1;
  int speckle_size_px = 100;
  double disparity_sigma_px = 0.25;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_range", self.min_range_m, {0.05, 100.0}, "m",
          "nearer things get no depth; matching takes longer the less");
    visit("max_range", self.max_range_m, {0.1, 60.0}, "m", "farther things get no depth");
    visit("block_size", self.block_size_px, {1, 21}, "px", "width of the patches that are compared; odd");
    visit("uniqueness", self.uniqueness_percent, {0, 100}, "%", "by which the best match must beat the second");
    visit("left_right_check", self.left_right_check_px, {0, 10}, "px",
          "how far matching back may lead from where it came");
    visit("speckle_size", self.speckle_size_px, {0, 10000}, "px", "smaller patches of one depth are dropped");
    visit("disparity_sigma", self.disparity_sigma_px, {0.01, 5.0}, "px",
          "standard deviation of a disparity: that of the depth is z² / (focal length × baseline) times it");
  }
};

}  // namespace wardslam::sources
