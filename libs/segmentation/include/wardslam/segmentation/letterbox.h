#pragma once

#include <opencv2/core.hpp>

namespace wardslam::segmentation {

/// How an image of any size fits into a network's input of fixed size: scaled alike in both directions, centred, the
/// rest grey. Coordinates of both are continuous: the top left corner of the top left pixel is (0, 0).
class Letterbox {
 public:
  Letterbox(cv::Size image_px, cv::Size input_px);

  /// Where the scaled image lies in the input.
  [[nodiscard]] const cv::Rect& content_px() const { return content_px_; }
  [[nodiscard]] const cv::Size& image_px() const { return image_px_; }
  [[nodiscard]] const cv::Size& input_px() const { return input_px_; }

  /// Image pixels to input pixels. They differ between the directions by rounding only.
  [[nodiscard]] double scaleX() const { return static_cast<double>(content_px_.width) / image_px_.width; }
  [[nodiscard]] double scaleY() const { return static_cast<double>(content_px_.height) / image_px_.height; }

  [[nodiscard]] cv::Rect2d toImage(const cv::Rect2d& inInput) const;

  /// The input picture: CV_8UC3, grey 114 (what YOLO networks are trained with) around the image.
  [[nodiscard]] cv::Mat apply(const cv::Mat& image) const;

 private:
  cv::Size image_px_;
  cv::Size input_px_;
  cv::Rect content_px_;
};

}  // namespace wardslam::segmentation
