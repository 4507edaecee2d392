#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "wardslam/core/segmentation.h"
#include "wardslam/segmentation/label_map.h"
#include "wardslam/segmentation/letterbox.h"

namespace wardslam::segmentation {

struct YoloDecoderOptions {
  double confidence = 0.15;  ///< Low: a person missed costs more than a wall taken for one.
  double nms_iou = 0.45;
  double mask_threshold = 0.5;
  int max_instances = 100;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// How a YOLO-seg network lays out its detections. Anchor by anchor: centre x, y, width, height (input pixels),
/// objectness (v5 only), one score per class, one coefficient per prototype. End to end, with suppression in the
/// network (yolo26, nms=True): row by row x and y of two corners (input pixels), confidence, number of the class,
/// coefficients.
struct YoloLayout {
  /// V5: [1, anchors, values]; V8: [1, values, anchors], no objectness; EndToEnd: [1, rows, values].
  enum class Version { V5, V8, EndToEnd };

  Version version = Version::V8;
  int anchors = 0;
  int classes = 0;  ///< 0: not told (EndToEnd).
  int prototypes = 0;

  /// From the shapes of the two outputs; the prototypes are [1, count, height, width]. Empty when they are not those
  /// of a segmentation network. There are always more anchors than values per anchor, which tells V5 and V8 apart.
  /// Where the size of the input is known, the number of anchors must be one that strides explain (8, 16, 32, and 4 or
  /// 64 besides), or it is none: rows of a fixed number. V5 has three anchors in a cell; with one it is told from V8
  /// turned round by how many classes are `named`.
  [[nodiscard]] static std::optional<YoloLayout> fromShapes(const std::vector<int>& detections,
                                                            const std::vector<int>& prototypes,
                                                            const cv::Size& input_px = {},
                                                            std::optional<std::size_t> named = {});
};

/// What comes out cannot be of the layout that its shape has, or of the classes that are named; says why, and what to
/// do, in part of a sentence.
class YoloLayoutError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Turns the two output tensors (CV_32F) into a segmentation of the image: detections above the confidence threshold,
/// non-maximum suppression per class, masks = sigmoid(coefficients x prototypes) inside each box, resampled linearly
/// before the threshold. Instances are numbered from 1 by falling confidence; where they overlap the more confident one
/// has the pixel, and one left without any is dropped, as is one of a class the labels leave unclassified. Throws
/// YoloLayoutError for a confidence above 1 and for what is no number of a class, or of none that is named.
[[nodiscard]] core::Segmentation decodeYolo(const cv::Mat& detections, const cv::Mat& prototypes,
                                            const YoloLayout& layout, const Letterbox& letterbox,
                                            const LabelMap& labels, const YoloDecoderOptions& options);

template <class Self, class Visitor>
void YoloDecoderOptions::describe(Self& self, Visitor& visit) {
  visit("confidence", self.confidence, {0.01, 1.0}, "", "detections below are dropped");
  visit("nms_iou", self.nms_iou, {0.0, 1.0}, "", "of two boxes of one class that overlap more, the weaker is dropped");
  visit("mask_threshold", self.mask_threshold, {0.01, 0.99}, "",
        "probability from which a pixel belongs to an instance");
  visit("max_instances", self.max_instances, {1, 1000}, "count", "most instances per image, the most confident first");
}

}  // namespace wardslam::segmentation
