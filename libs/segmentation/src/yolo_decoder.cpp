#include "wardslam/segmentation/yolo_decoder.h"

#include <algorithm>
#include <cmath>
#include <opencv2/dnn.hpp>
#include <utility>

#include "instance_painter.h"

namespace wardslam::segmentation {
namespace {

constexpr int kBoxValues = 4;
constexpr int kEndToEndValues = 6;  // box, confidence, class
constexpr int kAnchorsPerCell = 3;  // of v5
constexpr float kLargestClass = 65535.0F;
constexpr float kHighest = 1.001F;  // of a confidence, with what rounding adds
constexpr const char* kOtherLayout = "; it has another layout than those of YOLO-seg networks";

struct Detection {
  cv::Rect2d box_px;  // in the input
  float confidence = 0.0F;
  core::ClassId classId = 0;
  std::vector<float> coefficients;
};

void requireConfidence(float confidence) {
  if (std::isfinite(confidence) && confidence > kHighest) {
    throw YoloLayoutError("puts out a confidence of " + std::to_string(confidence) + ", which is above 1" +
                          kOtherLayout);
  }
}

/// Whether a grid of anchors over the input has so many: `perCell` in each cell of each stride.
bool isExplainedByStrides(int anchors, const cv::Size& input_px, int perCell) {
  static const std::vector<std::vector<int>> kStrides = {{8, 16, 32}, {8, 16, 32, 64}, {4, 8, 16, 32}};
  return std::any_of(kStrides.begin(), kStrides.end(), [&](const std::vector<int>& strides) {
    int cells = 0;
    for (const int stride : strides) cells += (input_px.width / stride) * (input_px.height / stride);
    return anchors == perCell * cells;
  });
}

/// V5 with one anchor a cell looks as V8 turned round does, with one class less: then names must tell how many there
/// are.
bool isSound(const YoloLayout& layout, const cv::Size& input_px, std::optional<std::size_t> named) {
  if (layout.classes < 1) return false;
  if (input_px.empty()) return true;
  const bool hasOnePerCell = isExplainedByStrides(layout.anchors, input_px, 1);
  if (layout.version == YoloLayout::Version::V8) return hasOnePerCell;
  const bool isNamed = named && static_cast<int>(*named) == layout.classes;
  return isExplainedByStrides(layout.anchors, input_px, kAnchorsPerCell) || (hasOnePerCell && isNamed);
}

std::optional<Detection> readAnchor(const float* values, const YoloLayout& layout, const LabelMap& labels,
                                    float threshold) {
  const bool hasObjectness = layout.version == YoloLayout::Version::V5;
  const float objectness = hasObjectness ? values[kBoxValues] : 1.0F;
  if (!(objectness >= threshold)) return std::nullopt;
  const float* scores = values + kBoxValues + (hasObjectness ? 1 : 0);
  const float* best = std::max_element(scores, scores + layout.classes);
  const float confidence = objectness * *best;
  requireConfidence(confidence);
  const core::ClassId classId = labels.classOf(static_cast<int>(best - scores));
  const bool isBoxFinite = std::all_of(values, values + kBoxValues, [](float value) { return std::isfinite(value); });
  if (!(confidence >= threshold) || classId == 0 || !isBoxFinite) return std::nullopt;
  const double width = values[2];
  const double height = values[3];
  const float* coefficients = scores + layout.classes;
  return Detection{{values[0] - width / 2, values[1] - height / 2, width, height},
                   confidence,
                   classId,
                   {coefficients, coefficients + layout.prototypes}};
}

/// A row of a network that suppresses itself.
std::optional<Detection> readRow(const float* values, const YoloLayout& layout, const LabelMap& labels,
                                 float threshold) {
  const float confidence = values[kBoxValues];
  if (!(confidence >= threshold)) return std::nullopt;
  requireConfidence(confidence);
  const float number = values[kBoxValues + 1];
  if (!(number >= 0.0F && number == std::floor(number))) {
    throw YoloLayoutError("puts out " + std::to_string(number) + " where the number of a class should be" +
                          kOtherLayout);
  }
  if (const auto listed = labels.listed(); listed && number >= static_cast<float>(*listed)) {
    throw YoloLayoutError("puts out class number " + std::to_string(static_cast<int>(std::min(number, kLargestClass))) +
                          ", counted from 0, with only " + std::to_string(*listed) +
                          " named; give the label file of this network: --classes FILE");
  }
  const core::ClassId classId = labels.classOf(static_cast<int>(std::min(number, kLargestClass)));
  const bool isBoxFinite = std::all_of(values, values + kBoxValues, [](float value) { return std::isfinite(value); });
  if (classId == 0 || !isBoxFinite) return std::nullopt;
  const float* coefficients = values + kEndToEndValues;
  return Detection{
      {values[0], values[1], static_cast<double>(values[2]) - values[0], static_cast<double>(values[3]) - values[1]},
      confidence,
      classId,
      {coefficients, coefficients + layout.prototypes}};
}

std::vector<Detection> readAnchors(const cv::Mat& detections, const YoloLayout& layout, const LabelMap& labels,
                                   float threshold) {
  const cv::Mat values = detections.reshape(1, detections.size[1]);
  std::vector<Detection> found;
  const auto read = [&](const float* anchor) {
    if (auto detection = readAnchor(anchor, layout, labels, threshold)) found.push_back(std::move(*detection));
  };
  if (layout.version == YoloLayout::Version::EndToEnd) {
    for (int i = 0; i < values.rows; ++i) {
      if (auto detection = readRow(values.ptr<float>(i), layout, labels, threshold)) found.push_back(*detection);
    }
    return found;
  }
  if (layout.version == YoloLayout::Version::V5) {
    for (int i = 0; i < values.rows; ++i) read(values.ptr<float>(i));
    return found;
  }
  // An anchor is a column here. Hardly any is worth the slow walk down it.
  cv::Mat best;
  cv::reduce(values.rowRange(kBoxValues, kBoxValues + layout.classes), best, 0, cv::REDUCE_MAX);
  for (int i = 0; i < values.cols; ++i) {
    if (best.at<float>(0, i) >= threshold) read(cv::Mat(values.col(i).t()).ptr<float>());
  }
  return found;
}

// Strongest first. Boxes of different classes are moved apart so that one run suppresses within classes only.
std::vector<Detection> suppress(const std::vector<Detection>& detections, const cv::Size& input_px,
                                const YoloDecoderOptions& options) {
  const double apart_px = 4.0 * std::max(input_px.width, input_px.height);
  std::vector<cv::Rect2d> boxes;
  std::vector<float> scores;
  for (const auto& detection : detections) {
    boxes.push_back(detection.box_px + cv::Point2d(apart_px * detection.classId, 0.0));
    scores.push_back(detection.confidence);
  }
  std::vector<int> kept;
  cv::dnn::NMSBoxes(boxes, scores, 0.0F, static_cast<float>(options.nms_iou), kept);
  kept.resize(std::min(kept.size(), static_cast<std::size_t>(options.max_instances)));
  std::vector<Detection> strongest;
  strongest.reserve(kept.size());
  for (const int index : kept) strongest.push_back(detections[static_cast<std::size_t>(index)]);
  return strongest;
}

// The prototypes and how image pixels fall onto them.
class MaskAssembler {
 public:
  MaskAssembler(const cv::Mat& prototypes, const Letterbox& letterbox, double threshold)
      : prototypes_(prototypes),
        size_(prototypes.size[3], prototypes.size[2]),
        logitThreshold_(std::log(threshold / (1.0 - threshold))) {
    const double strideX = static_cast<double>(letterbox.input_px().width) / size_.width;
    const double strideY = static_cast<double>(letterbox.input_px().height) / size_.height;
    scale_ = {letterbox.scaleX() / strideX, letterbox.scaleY() / strideY};
    offset_ = {letterbox.content_px().x / strideX, letterbox.content_px().y / strideY};
  }

  // 255 where the instance is; `box_px` lies in the image and is not empty.
  [[nodiscard]] cv::Mat assemble(const std::vector<float>& coefficients, const cv::Rect& box_px) const {
    const cv::Point2d first = toPrototype(box_px.tl());
    const cv::Point2d last = toPrototype(box_px.br() - cv::Point(1, 1));
    const cv::Point begin(clampX(std::floor(first.x)), clampY(std::floor(first.y)));
    const cv::Point end(clampX(std::ceil(last.x)) + 1, clampY(std::ceil(last.y)) + 1);
    const cv::Mat logits = weightedSum(coefficients, {begin, end});
    const cv::Point2d offset = cv::Point2d(box_px.x * scale_.x, box_px.y * scale_.y) + offset_ - cv::Point2d(begin);
    return thresholdResampled(logits, box_px.size(), scale_, offset, logitThreshold_);
  }

 private:
  // Pixel centre to pixel centre.
  [[nodiscard]] cv::Point2d toPrototype(const cv::Point& image_px) const {
    return {(image_px.x + 0.5) * scale_.x + offset_.x - 0.5, (image_px.y + 0.5) * scale_.y + offset_.y - 0.5};
  }
  [[nodiscard]] int clampX(double x) const { return std::clamp(static_cast<int>(x), 0, size_.width - 1); }
  [[nodiscard]] int clampY(double y) const { return std::clamp(static_cast<int>(y), 0, size_.height - 1); }

  [[nodiscard]] cv::Mat weightedSum(const std::vector<float>& coefficients, const cv::Rect& area) const {
    cv::Mat sum(area.size(), CV_32F, cv::Scalar(0));
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      const cv::Mat prototype(size_, CV_32F, const_cast<float*>(prototypes_.ptr<float>(0, static_cast<int>(i))));
      cv::scaleAdd(prototype(area), coefficients[i], sum, sum);
    }
    return sum;
  }

  const cv::Mat& prototypes_;
  cv::Size size_;
  cv::Point2d scale_;      // image pixels to prototype pixels
  cv::Point2d offset_;     // prototype pixels
  double logitThreshold_;  // sigmoid(logit) > threshold where the logit is above this
};

}  // namespace

std::optional<YoloLayout> YoloLayout::fromShapes(const std::vector<int>& detections, const std::vector<int>& prototypes,
                                                 const cv::Size& input_px, std::optional<std::size_t> named) {
  if (detections.size() != 3 || detections[0] != 1 || prototypes.size() != 4 || prototypes[0] != 1) return std::nullopt;
  if (*std::min_element(prototypes.begin(), prototypes.end()) < 1) return std::nullopt;
  YoloLayout layout;
  const bool hasEndToEndValues = detections[2] == kEndToEndValues + prototypes[1];
  const bool areAnchors = isExplainedByStrides(detections[1], input_px, kAnchorsPerCell) ||
                          isExplainedByStrides(detections[1], input_px, 1);
  if (!input_px.empty() && hasEndToEndValues && !areAnchors) {
    layout.version = Version::EndToEnd;
    layout.anchors = detections[1];
    layout.prototypes = prototypes[1];
    return layout;
  }
  layout.version = detections[1] > detections[2] ? Version::V5 : Version::V8;
  layout.anchors = std::max(detections[1], detections[2]);
  layout.prototypes = prototypes[1];
  const int objectness = layout.version == Version::V5 ? 1 : 0;
  layout.classes = std::min(detections[1], detections[2]) - kBoxValues - objectness - layout.prototypes;
  return isSound(layout, input_px, named) ? std::optional(layout) : std::nullopt;
}

core::Segmentation decodeYolo(const cv::Mat& detections, const cv::Mat& prototypes, const YoloLayout& layout,
                              const Letterbox& letterbox, const LabelMap& labels, const YoloDecoderOptions& options) {
  const auto found = readAnchors(detections, layout, labels, static_cast<float>(options.confidence));
  const MaskAssembler assembler(prototypes, letterbox, options.mask_threshold);
  InstancePainter painter(letterbox.image_px());
  for (const auto& detection : suppress(found, letterbox.input_px(), options)) {
    const cv::Rect box_px = roundedWithin(letterbox.toImage(detection.box_px), letterbox.image_px());
    if (box_px.empty()) continue;
    painter.paint(detection.classId, detection.confidence, box_px, assembler.assemble(detection.coefficients, box_px));
  }
  return painter.segmentation();
}

}  // namespace wardslam::segmentation
