#include "wardslam/segmentation/segmenter_factory.h"

namespace wardslam::segmentation {

std::unique_ptr<Segmenter> makeSegmenter(const SegmentationOptions& options) {
  switch (options.type) {
    case SegmentationOptions::Type::Depth:
      return std::make_unique<DepthSegmenter>(options.depth, options.classes, options.backend);
    case SegmentationOptions::Type::RecordedMasks:
      return std::make_unique<RecordedMasks>(options.recorded_masks, options.classes);
    case SegmentationOptions::Type::Yolo:
      return std::make_unique<YoloSegmenter>(options.yolo, options.classes, options.backend);
    case SegmentationOptions::Type::MaskRcnn:
      return std::make_unique<MaskRcnnSegmenter>(options.mask_rcnn, options.classes, options.backend);
    case SegmentationOptions::Type::Semantic:
      return std::make_unique<SemanticSegmenter>(options.semantic, options.classes, options.backend);
    case SegmentationOptions::Type::None:
      break;
  }
  return nullptr;
}

}  // namespace wardslam::segmentation
