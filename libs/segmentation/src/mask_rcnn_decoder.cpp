#include "wardslam/segmentation/mask_rcnn_decoder.h"

#include <algorithm>
#include <cmath>

#include "instance_painter.h"

namespace wardslam::segmentation {
namespace {

constexpr int kValues = 7;
enum Value { Class = 1, Score, Left, Top, Right, Bottom };  // after the number of the image in the batch

struct Detection {
  int row = 0;  // of detections and masks
  int classIndex = 0;
  core::ClassId classId = 0;
  float score = 0.0F;
  cv::Rect2d box;  // fractions of the image
};

std::optional<Detection> readRow(const cv::Mat& rows, int row, int classes, const LabelMap& labels, double confidence) {
  const auto* values = rows.ptr<float>(row);
  const bool isFinite = std::all_of(values, values + kValues, [](float value) { return std::isfinite(value); });
  if (!isFinite || values[Score] < confidence || values[Class] < 0.0F || values[Class] >= static_cast<float>(classes)) {
    return std::nullopt;
  }
  const auto index = static_cast<int>(values[Class]);
  const core::ClassId classId = labels.classOf(index);
  const cv::Rect2d box(values[Left], values[Top], values[Right] - values[Left], values[Bottom] - values[Top]);
  if (classId == 0 || box.empty()) return std::nullopt;
  return Detection{row, index, classId, values[Score], box};
}

std::vector<Detection> strongest(const cv::Mat& detections, const cv::Mat& masks, const LabelMap& labels,
                                 const MaskRcnnDecoderOptions& options) {
  const int count = std::min(detections.size[2], masks.size[0]);
  const int classes = masks.size[1];
  std::vector<Detection> found;
  const cv::Mat rows = count > 0 ? detections.reshape(1, detections.size[2]) : cv::Mat();
  for (int row = 0; row < count; ++row) {
    if (const auto detection = readRow(rows, row, classes, labels, options.confidence)) found.push_back(*detection);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.score > b.score; });
  found.resize(std::min(found.size(), static_cast<std::size_t>(options.max_instances)));
  return found;
}

}  // namespace

std::optional<int> maskRcnnClasses(const std::vector<int>& detections, const std::vector<int>& masks) {
  const bool fits = detections.size() == 4 && detections[0] == 1 && detections[1] == 1 && detections[3] == kValues &&
                    masks.size() == 4 && std::all_of(masks.begin() + 1, masks.end(), [](int size) { return size > 0; });
  return fits ? std::optional(masks[1]) : std::nullopt;
}

core::Segmentation decodeMaskRcnn(const cv::Mat& detections, const cv::Mat& masks, const LabelMap& labels,
                                  const cv::Size& image_px, const MaskRcnnDecoderOptions& options) {
  const cv::Size mask_px(masks.size[3], masks.size[2]);
  InstancePainter painter(image_px);
  for (const auto& detection : strongest(detections, masks, labels, options)) {
    const cv::Rect2d exact_px(detection.box.x * image_px.width, detection.box.y * image_px.height,
                              detection.box.width * image_px.width, detection.box.height * image_px.height);
    const cv::Rect box_px = roundedWithin(exact_px, image_px);
    if (box_px.empty()) continue;
    const cv::Mat mask(mask_px, CV_32F, const_cast<float*>(masks.ptr<float>(detection.row, detection.classIndex)));
    const cv::Point2d scale(mask_px.width / exact_px.width, mask_px.height / exact_px.height);
    const cv::Point2d offset((box_px.x - exact_px.x) * scale.x, (box_px.y - exact_px.y) * scale.y);
    painter.paint(detection.classId, detection.score, box_px,
                  thresholdResampled(mask, box_px.size(), scale, offset, options.mask_threshold));
  }
  return painter.segmentation();
}

}  // namespace wardslam::segmentation
