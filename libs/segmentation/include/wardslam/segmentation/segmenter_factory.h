#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "wardslam/segmentation/depth_segmenter.h"
#include "wardslam/segmentation/mask_rcnn_segmenter.h"
#include "wardslam/segmentation/network.h"
#include "wardslam/segmentation/recorded_masks.h"
#include "wardslam/segmentation/segmenter.h"
#include "wardslam/segmentation/semantic_segmenter.h"
#include "wardslam/segmentation/yolo_segmenter.h"

namespace wardslam::segmentation {

/// Section `segmentation:` of the configuration.
struct SegmentationOptions {
  enum class Type : std::uint8_t { None, Depth, RecordedMasks, Yolo, MaskRcnn, Semantic };

  Type type = Type::Depth;
  std::string classes;
  Backend backend = Backend::OpenCv;
  DepthOptions depth;
  RecordedMasksOptions recorded_masks;
  YoloOptions yolo;
  MaskRcnnOptions mask_rcnn;
  SemanticOptions semantic;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// What would have to be assumed of the masks or of the network's file, one sentence each: for who reads a program's
/// output. Reads files, runs no network. Throws core::InputError.
[[nodiscard]] std::vector<std::string> assumptionsOf(const SegmentationOptions& options);

/// Null for Type::None. Throws core::InputError.
[[nodiscard]] std::unique_ptr<Segmenter> makeSegmenter(const SegmentationOptions& options);

template <class Self, class Visitor>
void SegmentationOptions::describe(Self& self, Visitor& visit) {
  visit("type", self.type, {"none", "depth", "recorded_masks", "yolo", "mask_rcnn", "semantic"},
        "where masks come from; depth: the network that comes with the program, which sees the depth image alone");
  visit("classes", self.classes,
        "label file (labels/voc21.yaml, or lines of '<id> <name>'): what the class numbers of network or masks mean; "
        "empty: told by their count, by the file beside a depth network, or by what the masks bring");
  visit("backend", self.backend, {"opencv", "onnxruntime"}, "which library runs the network");
  visit.group("depth", self.depth);
  visit.group("recorded_masks", self.recorded_masks);
  visit.group("yolo", self.yolo);
  visit.group("mask_rcnn", self.mask_rcnn);
  visit.group("semantic", self.semantic);
}

}  // namespace wardslam::segmentation
