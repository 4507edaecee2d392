#include "wardslam/segmentation/yolo_decoder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

namespace wardslam::segmentation {
namespace {

constexpr int kBoxValues = 4;

struct Detection {
  cv::Rect2d box_px;  // in the input
  float confidence = 0.0F;
  core::ClassId classId = 0;
  const float* coefficients = nullptr;
};

std::optional<Detection> readAnchor(const float* values, const YoloLayout& layout, float threshold) {
  const bool hasObjectness = layout.version == YoloLayout::Version::V5;
  const float objectness = hasObjectness ? values[kBoxValues] : 1.0F;
  if (!(objectness >= threshold)) return std::nullopt;
  const float* scores = values + kBoxValues + (hasObjectness ? 1 : 0);
  const float* best = std::max_element(scores, scores + layout.classes);
  const float confidence = objectness * *best;
  const bool isBoxFinite = std::all_of(values, values + kBoxValues, [](float value) { return std::isfinite(value); });
  if (!(confidence >= threshold) || !isBoxFinite) return std::nullopt;
  const double width = values[2];
  const double height = values[3];
  return Detection{{values[0] - width / 2, values[1] - height / 2, width, height},
                   confidence,
                   static_cast<core::ClassId>(best - scores + 1),
                   scores + layout.classes};
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
        count_(prototypes.size[1]),
        size_(prototypes.size[3], prototypes.size[2]),
        logitThreshold_(std::log(threshold / (1.0 - threshold))) {
    const double strideX = static_cast<double>(letterbox.input_px().width) / size_.width;
    const double strideY = static_cast<double>(letterbox.input_px().height) / size_.height;
    scale_ = {letterbox.scaleX() / strideX, letterbox.scaleY() / strideY};
    offset_ = {letterbox.content_px().x / strideX, letterbox.content_px().y / strideY};
  }

  // 255 where the instance is; `box_px` lies in the image and is not empty.
  [[nodiscard]] cv::Mat assemble(const float* coefficients, const cv::Rect& box_px) const {
    const cv::Point2d first = toPrototype(box_px.tl());
    const cv::Point2d last = toPrototype(box_px.br() - cv::Point(1, 1));
    const cv::Point begin(clampX(std::floor(first.x)), clampY(std::floor(first.y)));
    const cv::Point end(clampX(std::ceil(last.x)) + 1, clampY(std::ceil(last.y)) + 1);
    const cv::Mat logits = weightedSum(coefficients, {begin, end});

    const cv::Matx23d fromBox(scale_.x, 0.0, first.x - begin.x, 0.0, scale_.y, first.y - begin.y);
    cv::Mat resampled;
    cv::warpAffine(logits, resampled, fromBox, box_px.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    return resampled > logitThreshold_;
  }

 private:
  // Pixel centre to pixel centre.
  [[nodiscard]] cv::Point2d toPrototype(const cv::Point& image_px) const {
    return {(image_px.x + 0.5) * scale_.x + offset_.x - 0.5, (image_px.y + 0.5) * scale_.y + offset_.y - 0.5};
  }
  [[nodiscard]] int clampX(double x) const { return std::clamp(static_cast<int>(x), 0, size_.width - 1); }
  [[nodiscard]] int clampY(double y) const { return std::clamp(static_cast<int>(y), 0, size_.height - 1); }

  [[nodiscard]] cv::Mat weightedSum(const float* coefficients, const cv::Rect& area) const {
    cv::Mat sum(area.size(), CV_32F, cv::Scalar(0));
    for (int i = 0; i < count_; ++i) {
      const cv::Mat prototype(size_, CV_32F, const_cast<float*>(prototypes_.ptr<float>(0, i)));
      cv::scaleAdd(prototype(area), coefficients[i], sum, sum);
    }
    return sum;
  }

  const cv::Mat& prototypes_;
  int count_;
  cv::Size size_;
  cv::Point2d scale_;      // image pixels to prototype pixels
  cv::Point2d offset_;     // prototype pixels
  double logitThreshold_;  // sigmoid(logit) > threshold where the logit is above this
};

cv::Rect roundedWithin(const cv::Rect2d& box, const cv::Size& image_px) {
  // Clamped before the conversion to integers, which a wild box would overflow.
  const auto edge = [](double value, int limit) { return cvRound(std::clamp(value, 0.0, static_cast<double>(limit))); };
  return {cv::Point(edge(box.x, image_px.width), edge(box.y, image_px.height)),
          cv::Point(edge(box.x + box.width, image_px.width), edge(box.y + box.height, image_px.height))};
}

void paint(core::Segmentation& segmentation, const Detection& detection, const cv::Rect& box_px, cv::Mat mask) {
  cv::Mat instanceIds = segmentation.instanceIds(box_px);
  mask &= instanceIds == 0;
  if (cv::countNonZero(mask) == 0) return;
  const auto id = static_cast<std::uint16_t>(segmentation.instances.size() + 1);
  instanceIds.setTo(id, mask);
  segmentation.classIds(box_px).setTo(detection.classId, mask);
  segmentation.instances.push_back({id, detection.classId, std::min(detection.confidence, 1.0F), box_px});
}

}  // namespace

std::optional<YoloLayout> YoloLayout::fromShapes(const std::vector<int>& detections,
                                                 const std::vector<int>& prototypes) {
  if (detections.size() != 3 || detections[0] != 1 || prototypes.size() != 4 || prototypes[0] != 1) return std::nullopt;
  YoloLayout layout;
  layout.version = detections[1] > detections[2] ? Version::V5 : Version::V8;
  layout.anchors = std::max(detections[1], detections[2]);
  layout.prototypes = prototypes[1];
  const int objectness = layout.version == Version::V5 ? 1 : 0;
  layout.classes = std::min(detections[1], detections[2]) - kBoxValues - objectness - layout.prototypes;
  const bool fits = layout.classes >= 1 && layout.classes <= std::numeric_limits<core::ClassId>::max() &&
                    *std::min_element(prototypes.begin(), prototypes.end()) > 0;
  return fits ? std::optional(layout) : std::nullopt;
}

core::Segmentation decodeYolo(const cv::Mat& detections, const cv::Mat& prototypes, const YoloLayout& layout,
                              const Letterbox& letterbox, const YoloDecoderOptions& options) {
  cv::Mat anchors = detections.reshape(1, detections.size[1]);
  if (layout.version == YoloLayout::Version::V8) anchors = anchors.t();

  std::vector<Detection> found;
  for (int i = 0; i < anchors.rows; ++i) {
    const auto detection = readAnchor(anchors.ptr<float>(i), layout, static_cast<float>(options.confidence));
    if (detection) found.push_back(*detection);
  }

  core::Segmentation segmentation;
  segmentation.classIds = cv::Mat(letterbox.image_px(), CV_8UC1, cv::Scalar(0));
  segmentation.instanceIds = cv::Mat(letterbox.image_px(), CV_16UC1, cv::Scalar(0));
  const MaskAssembler assembler(prototypes, letterbox, options.mask_threshold);
  for (const auto& detection : suppress(found, letterbox.input_px(), options)) {
    const cv::Rect box_px = roundedWithin(letterbox.toImage(detection.box_px), letterbox.image_px());
    if (box_px.empty()) continue;
    paint(segmentation, detection, box_px, assembler.assemble(detection.coefficients, box_px));
  }
  return segmentation;
}

}  // namespace wardslam::segmentation
