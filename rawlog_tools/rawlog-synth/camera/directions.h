#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace wardslam::synth {

/// Where the rays of an image's pixels lead, camera frame, z = 1.
struct Directions {
  cv::Mat x;  ///< CV_32FC1
  cv::Mat y;  ///< The same size.

  [[nodiscard]] cv::Size size() const { return x.size(); }
  [[nodiscard]] Eigen::Vector3f at(int x_px, int y_px) const {
    return {x.at<float>(y_px, x_px), y.at<float>(y_px, x_px), 1.0F};
  }
};

}  // namespace wardslam::synth
