#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "wardslam/core/segmentation.h"
#include "wardslam/segmentation/label_map.h"

namespace wardslam::segmentation {

struct MaskRcnnDecoderOptions {
  double confidence = 0.3;  ///< What OpenCV's description of the network lets through.
  double mask_threshold = 0.5;
  int max_instances = 100;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// How many classes the two outputs of a Mask R-CNN tell apart: detections [1, 1, count, 7] and masks [count, classes,
/// height, width]. Empty when the shapes are not those.
[[nodiscard]] std::optional<int> maskRcnnClasses(const std::vector<int>& detections, const std::vector<int>& masks);

/// Turns the output tensors (CV_32F) into a segmentation of the image. Each row of the detections: image number, class
/// index, score, left, top, right, bottom (fractions of the image). Row i of the masks holds one small picture of
/// probabilities per class, stretched over the box of detection i; that of its class, resampled linearly, is cut at the
/// threshold (P3). Instances are numbered from 1 by falling score; where they overlap the more confident one has the
/// pixel, and one left without any is dropped, as is one of a class the labels leave unclassified.
[[nodiscard]] core::Segmentation decodeMaskRcnn(const cv::Mat& detections, const cv::Mat& masks, const LabelMap& labels,
                                                const cv::Size& image_px, const MaskRcnnDecoderOptions& options);

template <class Self, class Visitor>
void MaskRcnnDecoderOptions::describe(Self& self, Visitor& visit) {
  visit("confidence", self.confidence, {0.01, 1.0}, "", "detections below are dropped");
  visit("mask_threshold", self.mask_threshold, {0.01, 0.99}, "",
        "probability from which a pixel belongs to an instance");
  visit("max_instances", self.max_instances, {1, 1000}, "count", "most instances per image, the most confident first");
}

}  // namespace wardslam::segmentation
