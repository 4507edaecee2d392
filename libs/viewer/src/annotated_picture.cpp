#include "wardslam/viewer/annotated_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <string>

namespace wardslam::viewer {
namespace {

const cv::Scalar kStaticColor(80, 220, 80);
const cv::Scalar kDynamicColor(60, 60, 255);
const cv::Scalar kPaper(30, 30, 30);
const cv::Scalar kInk(240, 240, 240);
constexpr double kMaskOpacity = 0.4;
constexpr double kTextScale = 0.45;

/// Colours of neighbouring ids lie far apart on the colour circle; people (id 1) are red.
cv::Scalar colorOf(core::ClassId id) {
  constexpr int kGoldenAngle = 111;  // in OpenCV's half degrees, of 180
  const cv::Mat hsv(1, 1, CV_8UC3, cv::Scalar(((id - 1) * kGoldenAngle) % 180, 200, 255));
  cv::Mat bgr;
  cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
  return cv::Scalar(bgr.at<cv::Vec3b>(0, 0));
}

void writeOnPaper(cv::Mat& picture, const std::string& text, cv::Point corner) {
  int baseline = 0;
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kTextScale, 1, &baseline);
  corner.x = std::clamp(corner.x, 0, std::max(0, picture.cols - size.width - 4));
  corner.y = std::clamp(corner.y, 0, std::max(0, picture.rows - size.height - 6));
  cv::rectangle(picture, {corner.x, corner.y, size.width + 4, size.height + 6}, kPaper, cv::FILLED);
  cv::putText(picture, text, {corner.x + 2, corner.y + size.height + 2}, cv::FONT_HERSHEY_SIMPLEX, kTextScale, kInk, 1,
              cv::LINE_AA);
}

void paintMasks(cv::Mat& picture, const core::Segmentation& segmentation) {
  cv::Mat colors(1, 256, CV_8UC3, cv::Scalar(0, 0, 0));
  for (int id = 1; id < 256; ++id) {
    const cv::Scalar color = colorOf(static_cast<core::ClassId>(id));
    colors.at<cv::Vec3b>(id) = cv::Vec3b(cv::saturate_cast<uchar>(color[0]), cv::saturate_cast<uchar>(color[1]),
                                         cv::saturate_cast<uchar>(color[2]));
  }
  cv::Mat classes;
  cv::Mat painted;
  cv::cvtColor(segmentation.classIds, classes, cv::COLOR_GRAY2BGR);
  cv::LUT(classes, colors, painted);
  cv::Mat blended;
  cv::addWeighted(picture, 1.0 - kMaskOpacity, painted, kMaskOpacity, 0.0, blended);
  blended.copyTo(picture, segmentation.classIds != 0);
}

void drawBoxes(cv::Mat& picture, const core::Segmentation& segmentation, const core::LabelSpace& labels) {
  for (const core::Instance& instance : segmentation.instances) {
    const cv::Scalar color = colorOf(instance.classId);
    const std::string& name = labels.name(instance.classId);
    const int percent = cvRound(instance.confidence * 100.0F);
    cv::rectangle(picture, instance.box_px, color, 1);
    writeOnPaper(
        picture,
        (name.empty() ? "class " + std::to_string(instance.classId) : name) + " " + std::to_string(percent) + "%",
        instance.box_px.tl());
  }
}

}  // namespace

cv::Mat drawAnnotated(const core::Frame& frame, const core::LabelSpace& labels) {
  cv::Mat picture = frame.color_bgr.clone();
  if (!frame.segmentation.empty()) {
    paintMasks(picture, frame.segmentation);
    drawBoxes(picture, frame.segmentation, labels);
  }
  std::size_t dynamic = 0;
  for (const core::Keypoint& keypoint : frame.features.keypoints) {
    const bool isDynamic = keypoint.motion == core::Motion::Dynamic;
    dynamic += isDynamic ? 1 : 0;
    cv::circle(picture, keypoint.raw_px, 2, isDynamic ? kDynamicColor : kStaticColor, 1, cv::LINE_AA);
  }
  writeOnPaper(
      picture,
      std::to_string(frame.features.size() - dynamic) + " static, " + std::to_string(dynamic) + " dynamic key points",
      {4, picture.rows});
  return picture;
}

}  // namespace wardslam::viewer
