#include "wardslam/segmentation/segmenter_factory.h"

#include <fstream>
#include <iterator>
#include <string>

#include "class_names.h"
#include "onnx_file.h"

namespace wardslam::segmentation {
namespace {

constexpr std::size_t kNamesInSentence = 5;

std::string readBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether detections of 80 classes come out, with 32 coefficients, as the file declares them.
bool declares80Classes(const std::string& bytes) {
  for (const auto& shape : onnxOutputShapes(bytes)) {
    const bool isV8 = shape.size() == 3 && shape[1] == 4 + 80 + 32;
    const bool isV5 = shape.size() == 3 && shape[2] == 5 + 80 + 32;
    if (isV5 || isV8) return true;
  }
  return false;
}

/// Whose names the classes get, where no label file says so.
std::vector<std::string> assumptionsOf(const YoloOptions& options) {
  const std::string bytes = readBytes(options.model);
  const auto metadata = onnxMetadata(bytes);
  const auto found = metadata.find("names");
  const auto names = found == metadata.end() ? std::vector<std::string>{} : parseClassNames(found->second);
  if (names.empty()) {
    if (!declares80Classes(bytes)) return {};
    return {options.model + ": brings no names of its 80 classes; they are taken for those of COCO"};
  }
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kNamesInSentence; ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > kNamesInSentence) text += ", …";
  return {options.model + ": its classes have the names that the file brings (" + std::to_string(names.size()) + ": " +
          text + ")"};
}

}  // namespace

std::vector<std::string> assumptionsOf(const SegmentationOptions& options) {
  if (options.type == SegmentationOptions::Type::RecordedMasks) {
    return RecordedMasks(options.recorded_masks, options.classes).notes();
  }
  if (options.type == SegmentationOptions::Type::Yolo && options.classes.empty()) return assumptionsOf(options.yolo);
  return {};
}

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
