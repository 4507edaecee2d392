#include "wardslam/segmentation/letterbox.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace wardslam::segmentation {

Letterbox::Letterbox(cv::Size image_px, cv::Size input_px) : image_px_(image_px), input_px_(input_px) {
  const double scale = std::min(static_cast<double>(input_px.width) / image_px.width,
                                static_cast<double>(input_px.height) / image_px.height);
  const int width = std::max(1, cvRound(scale * image_px.width));
  const int height = std::max(1, cvRound(scale * image_px.height));
  content_px_ = {(input_px.width - width) / 2, (input_px.height - height) / 2, width, height};
}

cv::Rect2d Letterbox::toImage(const cv::Rect2d& inInput) const {
  return {(inInput.x - content_px_.x) / scaleX(), (inInput.y - content_px_.y) / scaleY(), inInput.width / scaleX(),
          inInput.height / scaleY()};
}

cv::Mat Letterbox::apply(const cv::Mat& image) const {
  cv::Mat input(input_px_, CV_8UC3, cv::Scalar::all(114));
  cv::Mat content = input(content_px_);
  cv::resize(image, content, content.size());
  return input;
}

}  // namespace wardslam::segmentation
