#include "wardslam/core/people.h"

#include <opencv2/imgproc.hpp>

namespace wardslam::core {
namespace {

constexpr int kMargin_px = 8;
constexpr int kGrey = 128;

}  // namespace

cv::Mat peoplePixels(const cv::Mat& labelBits) {
  constexpr int kPeople = bitOf(PixelLabel::Person) | bitOf(PixelLabel::Dynamic);
  cv::Mat people = (labelBits & kPeople) != 0;
  const int side = 2 * kMargin_px + 1;
  cv::dilate(people, people, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return people;
}

cv::Mat peoplePixels(const Frame& frame) {
  const bool isLookedFor = !frame.segmentation.empty() && !frame.labelBits.empty();
  return isLookedFor ? peoplePixels(frame.labelBits) : cv::Mat(frame.gray.size(), CV_8UC1, cv::Scalar(255));
}

cv::Mat blanked(const cv::Mat& image, const cv::Mat& people) {
  cv::Mat mask = people;
  if (mask.size() != image.size()) cv::resize(people, mask, image.size(), 0, 0, cv::INTER_NEAREST);
  cv::Mat copy = image.clone();
  copy.setTo(cv::Scalar::all(kGrey), mask);
  return copy;
}

}  // namespace wardslam::core
