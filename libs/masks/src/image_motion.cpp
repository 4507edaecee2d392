#include "wardslam/masks/image_motion.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <utility>

namespace wardslam::masks {
namespace {

constexpr double kWidth_px = 320.0;

/// Where each pixel is: the trail of no steps.
cv::Mat grid(cv::Size size) {
  cv::Mat places(size, CV_32FC2);
  if (places.empty()) return places;
  places.forEach<cv::Vec2f>([](cv::Vec2f& place, const int* at) {
    place = {static_cast<float>(at[1]), static_cast<float>(at[0])};
  });
  return places;
}

}  // namespace

SmallPicture shrink(const cv::Mat& gray, const cv::Mat& depth_m, double stamp_s) {
  const int factor = std::max(1, static_cast<int>(std::lround(gray.cols / kWidth_px)));
  const cv::Size size(std::max(1, gray.cols / factor), std::max(1, gray.rows / factor));
  SmallPicture picture;
  picture.stamp_s = stamp_s;
  cv::resize(gray, picture.gray, size, 0, 0, cv::INTER_AREA);
  if (depth_m.empty()) {
    picture.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(0));
  } else {
    cv::resize(depth_m, picture.depth_m, size, 0, 0, cv::INTER_NEAREST);  // never a mean of near and far
  }
  return picture;
}

class ImageMotion::Flow {
 public:
  cv::Mat calculate(const cv::Mat& from, const cv::Mat& to) {
    cv::Mat flow;
    if (std::min(from.cols, from.rows) < kMinSide_px) {
      flow = cv::Mat(from.size(), CV_32FC2, cv::Scalar::all(0));
    } else {
      dis_->calc(from, to, flow);
    }
    return flow;
  }

 private:
  static constexpr int kMinSide_px = 32;  ///< DIS needs a pyramid.
  cv::Ptr<cv::DISOpticalFlow> dis_ = cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_ULTRAFAST);
};

ImageMotion::ImageMotion() : flow_(std::make_unique<Flow>()) {}
ImageMotion::~ImageMotion() = default;
ImageMotion::ImageMotion(ImageMotion&&) noexcept = default;
ImageMotion& ImageMotion::operator=(ImageMotion&&) noexcept = default;

void ImageMotion::advance(SmallPicture picture) {
  const bool follows = picture_.gray.size() == picture.gray.size();
  step_ = follows ? flow_->calculate(picture.gray, picture_.gray) : cv::Mat();
  picture_ = std::move(picture);
}

Trail::Trail(SmallPicture start) : start_(std::move(start)), places_(grid(start_.gray.size())) {}

void Trail::follow(const cv::Mat& step) {
  const cv::Mat before = grid(step.size()) + step;
  cv::Mat joined;
  cv::remap(places_, joined, before, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  places_ = joined;
  ++steps_;
}

}  // namespace wardslam::masks
