#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "depth_surfaces.h"
#include "wardslam/masks/contour_refiner.h"

namespace wardslam::masks {

/// What one instance and its surroundings look like, at the resolution contours are worked out in.
struct InstanceCrop {
  cv::Mat inverseDepth;             ///< CV_32FC1, 1/m, 0 = none.
  core::DepthNoise depthNoise;      ///< Of what was measured.
  cv::Mat color_bgr;                ///< CV_8UC3
  cv::Mat mask;                     ///< CV_8UC1, 255 on the instance.
  cv::Mat isFree;                   ///< CV_8UC1, 255 where there is no instance.
  float medianInverseDepth = 0.0F;  ///< Of the instance, 1/m.
  int maxGrowth_px = 0;             ///< At this resolution.
};

/// So many pixels around the mask of an instance belong into its view.
inline constexpr int kSurroundings_px = 18;

/// Works out the mask of one instance anew; see ContourRefiner for the steps.
class InstanceContour {
 public:
  InstanceContour(const InstanceCrop& view, const ContourOptions& options);

  /// CV_8UC1, 255 on the instance; covers none of the other instances.
  [[nodiscard]] cv::Mat refined();

 private:
  void removeForeignSurfaces();
  void grow();
  void settleUnmeasured();

  [[nodiscard]] std::vector<char> findForeignSurfaces() const;
  [[nodiscard]] bool isJoined(cv::Point a, cv::Point b) const;

  const InstanceCrop& view_;
  const ContourOptions& options_;
  cv::Mat measured_;   ///< 255 where there is depth.
  cv::Mat available_;  ///< 255 where no other instance is.
  cv::Mat onPlane_;    ///< 255 on what the thing stands on or leans against.
  Surfaces surfaces_;
  cv::Mat foreign_;           ///< 255 on surfaces that are not of the thing.
  cv::Mat looksLikeOutside_;  ///< 255 where the colour speaks for the background.
  cv::Mat mask_;              ///< As far as worked out.
};

}  // namespace wardslam::masks
