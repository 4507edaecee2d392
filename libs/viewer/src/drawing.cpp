#include "drawing.h"

#include <algorithm>

namespace wardslam::viewer {

void blend(cv::Mat picture, const cv::Scalar& color, double opacity, const cv::Mat& mask) {
  if (picture.empty()) return;
  const cv::Mat paint(picture.size(), picture.type(), color);
  cv::Mat blended;
  cv::addWeighted(picture, 1.0 - opacity, paint, opacity, 0.0, blended);
  mask.empty() ? blended.copyTo(picture) : blended.copyTo(picture, mask);
}

cv::Size tagSize(const std::string& text) {
  int baseline = 0;
  const cv::Size ink = cv::getTextSize(text, kFont, kTextScale, 1, &baseline);
  return {ink.width + 2 * kPadding_px, ink.height + 2 * kPadding_px + 1};
}

void writeTag(cv::Mat& picture, const std::string& text, cv::Point corner, const cv::Scalar& paper) {
  const cv::Size strip = tagSize(text);
  corner.x = std::clamp(corner.x, 0, std::max(0, picture.cols - strip.width));
  corner.y = std::clamp(corner.y, 0, std::max(0, picture.rows - strip.height));
  const cv::Rect area = cv::Rect(corner, strip) & cv::Rect({0, 0}, picture.size());
  blend(picture(area), paper, kPaperOpacity);
  cv::putText(picture, text, corner + cv::Point(kPadding_px, strip.height - kPadding_px - 1), kFont, kTextScale, kInk,
              1, cv::LINE_AA);
}

}  // namespace wardslam::viewer
