#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/segmentation/letterbox.h"

namespace wardslam::segmentation {

/// A depth image of the size of a network's input, and the pinhole camera that would take it.
struct DepthPicture {
  cv::Mat depth_m;  ///< CV_32FC1, 0 = none.
  double fx_px = 0.0;
  double fy_px = 0.0;
  double cx_px = 0.0;  ///< Pixel (0, 0) is the centre of the top left pixel.
  double cy_px = 0.0;
};

/// The image fitted into the input: of the pixels that fall into one the nearest measured one, around the image
/// nothing. `depth_m`: CV_32FC1 of the size the letterbox is for; what is not above 0 (or not a number) is none.
[[nodiscard]] DepthPicture fitDepth(const cv::Mat& depth_m, const core::CameraModel& camera,
                                    const Letterbox& letterbox);

/// What a depth network sees: CV_32F [1, 6, height, width]. With z in metres, w = 1/z, x = (u - cx)/fx, y = (v -
/// cy)/fy: w; 1; the first two components of the surface's normal, which is (a, b, w - x a - y b) with a = fx dw/du and
/// b = fy dw/dv, as 1/z is linear over a plane; x z/3 and y z/3, cut to +-1.5. All 0 where nothing was measured.
/// Slopes: the mean of w over the two columns (rows) to either side, 5 pixels long, apart 3 px; 0 where either holds
/// fewer than 3 measured pixels. The same as `input_channels()` in training/evaluate.py.
[[nodiscard]] cv::Mat depthChannels(const DepthPicture& picture);

inline constexpr int kDepthChannels = 6;

}  // namespace wardslam::segmentation
