#pragma once

#include <memory>
#include <opencv2/core.hpp>

namespace wardslam::masks {

/// A picture at the resolution at which motion is followed.
struct SmallPicture {
  double stamp_s = 0.0;
  cv::Mat gray;     ///< CV_8UC1
  cv::Mat depth_m;  ///< CV_32FC1, 0 = none.

  [[nodiscard]] bool empty() const { return gray.empty(); }
};

/// About 320 pixels wide. `gray`: CV_8UC1. `depth_m`: CV_32FC1 of the same size, 0 = none; or empty: none anywhere.
[[nodiscard]] SmallPicture shrink(const cv::Mat& gray, const cv::Mat& depth_m, double stamp_s);

/// Motion of every pixel against the picture before, whatever made it: dense optical flow by DIS (Kroeger et al., "Fast
/// Optical Flow using Dense Inverse Search", ECCV 2016).
class ImageMotion {
 public:
  ImageMotion();
  ~ImageMotion();
  ImageMotion(ImageMotion&&) noexcept;
  ImageMotion& operator=(ImageMotion&&) noexcept;

  /// The next picture, in order of time. After one of another size it starts anew.
  void advance(SmallPicture picture);

  [[nodiscard]] const SmallPicture& picture() const { return picture_; }

  /// The step back to the picture before: pixel p of this one was at p + step(p) then. CV_32FC2, px; empty at the
  /// start.
  [[nodiscard]] const cv::Mat& step() const { return step_; }

 private:
  class Flow;

  std::unique_ptr<Flow> flow_;
  SmallPicture picture_;
  cv::Mat step_;
};

/// The way back from the newest picture to an earlier one, joined step by step: its cost does not grow with its length.
class Trail {
 public:
  Trail() = default;
  explicit Trail(SmallPicture start);

  /// One picture further: ImageMotion::step().
  void follow(const cv::Mat& step);

  [[nodiscard]] const SmallPicture& start() const { return start_; }

  /// Where each pixel of the newest picture was in the first: CV_32FC2, px; may lie outside the image.
  [[nodiscard]] const cv::Mat& places() const { return places_; }

  [[nodiscard]] int steps() const { return steps_; }

 private:
  SmallPicture start_;
  cv::Mat places_;
  int steps_ = 0;
};

}  // namespace wardslam::masks
