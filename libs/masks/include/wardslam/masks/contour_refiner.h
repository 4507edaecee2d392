#pragma once

#include <bitset>
#include <opencv2/core.hpp>

#include "wardslam/core/depth_noise.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::masks {

struct ContourOptions {
  int max_growth_px = 14;
  double max_behind_m = 0.6;
  double min_surface_share = 0.25;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// Moves the outlines of masks to where the depth image says that things end (P14). A network draws outlines some
/// pixels off: over the background, or short of a hand. Depth tells surfaces apart. Of each instance:
///
///  1. Surfaces (pixels of continuous depth) that lie mostly outside the mask, or clearly behind the thing, leave it.
///  2. The mask grows along its surfaces to their edges. It does not grow onto surfaces that go on beyond its reach,
///     such as the floor under the feet or the bed a person leans on, nor into other instances.
///  3. Where nothing was measured (a Kinect's shadow beside each silhouette, hair, black cloth) the colours of thing
///     and background decide near the outline; farther in, the mask stays as it is.
///
/// Works on an image of about 320 columns whatever the size of the frame. Stateless and repeatable.
class ContourRefiner {
 public:
  using ClassSet = std::bitset<256>;  ///< Bit i stands for class i.

  ContourRefiner(const ContourOptions& options, const ClassSet& classes) : options_(options), classes_(classes) {}

  /// `found` with the outlines of the instances of these classes refined, and boxes to fit; it shares no changed
  /// pixels. `color_bgr` is CV_8UC3, `depth_m` CV_32FC1 with 0 = none and noise as told. An instance with little depth,
  /// or one that would lose most of its pixels, is left alone; where images are empty or differ in size, `found` comes
  /// back unchanged.
  [[nodiscard]] core::Segmentation refine(const cv::Mat& color_bgr, const cv::Mat& depth_m,
                                          const core::DepthNoise& depthNoise, const core::Segmentation& found) const;

 private:
  ContourOptions options_;
  ClassSet classes_;
};

template <class Self, class Visitor>
void ContourOptions::describe(Self& self, Visitor& visit) {
  visit("max_growth", self.max_growth_px, {0, 200}, "px", "farthest a mask grows along its surface");
  visit("max_behind", self.max_behind_m, {0.05, 10.0}, "m",
        "separate surfaces in a mask farther behind the middle of the thing are background");
  visit("min_surface_share", self.min_surface_share, {0.0, 1.0}, "",
        "a surface of which less lies within the mask is background");
}

}  // namespace wardslam::masks
