#include "wardslam/viewer/annotated_picture.h"

#include <algorithm>
#include <array>
#include <map>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"

namespace wardslam::viewer {
namespace {

const cv::Vec3b kStaticColor(90, 220, 90);
const cv::Vec3b kDynamicColor(60, 60, 245);
constexpr double kDynamicOpacity = 0.5;
constexpr double kStaticOpacity = 0.28;
/// Smaller things keep their mask, but a tag would cover more than the thing.
constexpr double kSmallestTagged = 0.004;  // of the image

/// Neighbouring ids lie far apart on the colour circle. Red and its neighbours are kept for what is dynamic.
cv::Vec3b colorOf(core::ClassId id) {
  constexpr int kFirstHue = 20;  // OpenCV's hues are half degrees: 0 … 179
  constexpr int kHues = 122;
  constexpr int kGoldenSection = 75;  // of kHues
  const cv::Mat hsv(1, 1, CV_8UC3, cv::Scalar(kFirstHue + id * kGoldenSection % kHues, 170, 235));
  cv::Mat bgr;
  cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
  return bgr.at<cv::Vec3b>(0, 0);
}

/// Takes the colours out, so that what is painted over it shows true.
void fade(cv::Mat picture, const cv::Mat& mask) {
  cv::Mat gray;
  cv::cvtColor(picture, gray, cv::COLOR_BGR2GRAY);
  cv::cvtColor(gray, gray, cv::COLOR_GRAY2BGR);
  gray.copyTo(picture, mask);
}

struct Count {
  std::size_t ofStatic = 0;
  std::size_t ofDynamic = 0;
};

Count countKeypoints(const core::Features& features) {
  Count count;
  for (const auto& keypoint : features.keypoints) {
    ++(keypoint.motion == core::Motion::Dynamic ? count.ofDynamic : count.ofStatic);
  }
  return count;
}

/// Key points on each instance, by instance id.
std::map<int, Count> countByInstance(const core::Frame& frame) {
  std::map<int, Count> counts;
  const cv::Rect image({0, 0}, frame.segmentation.instanceIds.size());
  for (const auto& keypoint : frame.features.keypoints) {
    const cv::Point pixel(cvRound(keypoint.raw_px.x), cvRound(keypoint.raw_px.y));
    if (!image.contains(pixel)) continue;
    Count& count = counts[frame.segmentation.instanceIds.at<std::uint16_t>(pixel)];
    ++(keypoint.motion == core::Motion::Dynamic ? count.ofDynamic : count.ofStatic);
  }
  return counts;
}

std::string tagOf(const core::Instance& instance, const core::LabelSpace& labels) {
  const std::string& name = labels.name(instance.classId);
  const std::string text = name.empty() ? "class " + std::to_string(instance.classId) : name;
  const int percent = cvRound(100.0F * instance.confidence);
  return percent == 100 ? text : text + " " + std::to_string(percent) + "%";
}

class Painter {
 public:
  Painter(const core::Frame& frame, const core::LabelSpace& labels)
      : frame_(frame), labels_(labels), picture_(frame.color_bgr.clone()) {}

  [[nodiscard]] cv::Mat paint();

 private:
  void paintMasks();
  void paintMask(const core::Instance& instance);
  void tagInstances();
  void paintKeypoints();
  void paintLegend();
  [[nodiscard]] bool isDynamic(const core::Instance& instance) const;
  [[nodiscard]] cv::Scalar colorFor(const core::Instance& instance) const {
    return isDynamic(instance) ? kDynamicColor : colorOf(instance.classId);
  }

  const core::Frame& frame_;
  const core::LabelSpace& labels_;
  cv::Mat picture_;
  std::map<int, Count> counts_;
};

cv::Mat Painter::paint() {
  if (!frame_.segmentation.instanceIds.empty()) {
    counts_ = countByInstance(frame_);
    paintMasks();
  }
  paintKeypoints();
  tagInstances();
  paintLegend();
  return picture_;
}

/// The filters decide key point by key point; a thing is shown as most of its points are.
bool Painter::isDynamic(const core::Instance& instance) const {
  const auto count = counts_.find(instance.id);
  return count != counts_.end() && count->second.ofDynamic > count->second.ofStatic;
}

void Painter::paintMasks() {
  for (const auto& instance : frame_.segmentation.instances) paintMask(instance);
}

void Painter::paintMask(const core::Instance& instance) {
  const cv::Rect area = instance.box_px & cv::Rect({0, 0}, picture_.size());
  if (area.empty()) return;
  const cv::Mat mask = frame_.segmentation.instanceIds(area) == static_cast<int>(instance.id);
  cv::Mat part = picture_(area);
  const cv::Scalar color = colorFor(instance);
  if (isDynamic(instance)) fade(part, mask);
  blend(part, color, isDynamic(instance) ? kDynamicOpacity : kStaticOpacity, mask);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::drawContours(part, contours, -1, color, 1, cv::LINE_AA);
}

void Painter::tagInstances() {
  for (const auto& instance : frame_.segmentation.instances) {
    if (instance.box_px.area() < kSmallestTagged * static_cast<double>(picture_.total())) continue;
    const cv::Scalar color = colorFor(instance);
    cv::rectangle(picture_, instance.box_px, color, 1);
    writeTag(picture_, tagOf(instance, labels_), instance.box_px.tl(), color * 0.55);
  }
}

void Painter::paintKeypoints() {
  for (const auto& keypoint : frame_.features.keypoints) {
    const cv::Scalar color = keypoint.motion == core::Motion::Dynamic ? kDynamicColor : kStaticColor;
    cv::circle(picture_, keypoint.raw_px, 3, kPaper, cv::FILLED, cv::LINE_AA);
    cv::circle(picture_, keypoint.raw_px, 2, color, cv::FILLED, cv::LINE_AA);
  }
}

void Painter::paintLegend() {
  const Count count = countKeypoints(frame_.features);
  const std::array<std::pair<std::string, cv::Vec3b>, 2> lines = {
      {{std::to_string(count.ofStatic) + " static key points", kStaticColor},
       {std::to_string(count.ofDynamic) + " dynamic, left out", kDynamicColor}}};
  constexpr int kLine_px = 17;
  constexpr int kWidth_px = 172;
  const int height_px = kLine_px * static_cast<int>(lines.size()) + 2 * kPadding_px;
  const cv::Rect area =
      cv::Rect(6, picture_.rows - height_px - 6, kWidth_px, height_px) & cv::Rect({0, 0}, picture_.size());
  blend(picture_(area), kPaper, kPaperOpacity);
  cv::Point at(area.x + 11, area.y + kPadding_px + kLine_px / 2);
  for (const auto& [text, color] : lines) {
    cv::circle(picture_, at, 4, color, cv::FILLED, cv::LINE_AA);
    cv::putText(picture_, text, at + cv::Point(10, 4), kFont, kTextScale, kInk, 1, cv::LINE_AA);
    at.y += kLine_px;
  }
}

}  // namespace

cv::Mat drawAnnotated(const core::Frame& frame, const core::LabelSpace& labels) {
  return Painter(frame, labels).paint();
}

}  // namespace wardslam::viewer
