#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "wardslam/segmentation/recorded_masks.h"
#include "wardslam/segmentation/segmenter.h"
#include "wardslam/segmentation/yolo_segmenter.h"

namespace wardslam::segmentation {

/// Section `segmentation:` of the configuration.
struct SegmentationOptions {
  enum class Type : std::uint8_t { None, RecordedMasks, Yolo };

  Type type = Type::None;
  std::string classes;
  RecordedMasksOptions recorded_masks;
  YoloOptions yolo;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// Null for Type::None. Throws core::InputError.
[[nodiscard]] std::unique_ptr<Segmenter> makeSegmenter(const SegmentationOptions& options);

template <class Self, class Visitor>
void SegmentationOptions::describe(Self& self, Visitor& visit) {
  visit("type", self.type, {"none", "recorded_masks", "yolo"}, "where masks come from");
  visit("classes", self.classes,
        "file of '<id> <name>' lines that extends the COCO names; empty: what the masks bring");
  visit.group("recorded_masks", self.recorded_masks);
  visit.group("yolo", self.yolo);
}

}  // namespace wardslam::segmentation
