#include "wardslam/segmentation/yolo_segmenter.h"

#include <opencv2/dnn.hpp>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

NetworkSource sourceOf(const YoloOptions& options, Backend backend) {
  NetworkSource source;
  source.model = options.model;
  source.backend = backend;
  source.kind = "YOLO-seg";
  source.key = "yolo.model";
  source.needsFixedInput = true;
  source.advice =
      "; official YOLOv8-seg exports need OpenCV 4.7 or newer and opset=12, YOLOv5-seg exports (export.py --include "
      "onnx "
      "--opset 12) run on OpenCV 4.6 too";
  return source;
}

cv::Mat blobOf(const cv::Mat& input_bgr) {
  constexpr bool kSwapToRgb = true;
  return cv::dnn::blobFromImage(input_bgr, 1.0 / 255.0, {}, {}, kSwapToRgb);
}

/// How many classes are named, where that is told.
std::optional<std::size_t> namedClasses(const fs::path& classesFile, const std::vector<std::string>& names) {
  if (!classesFile.empty()) return LabelMap::fromFile(classesFile).listed();
  return names.empty() ? std::nullopt : std::optional(names.size());
}

LabelMap labelsFor(const YoloLayout& layout, const fs::path& classesFile, const std::string& model,
                   const std::vector<std::string>& names) {
  if (layout.version != YoloLayout::Version::EndToEnd) {
    return LabelMap::forNetwork(layout.classes, classesFile, model, names, LabelMap::Family::Yolo);
  }
  if (!classesFile.empty()) return LabelMap::fromFile(classesFile);
  if (!names.empty()) return LabelMap::fromNames(names, model);
  throw core::InputError(model + ": puts out numbers of classes and brings no names for them; say what they mean: " +
                         "--classes labels/coco80.yaml where they are COCO's, else a file with 'classes: [person, …]'");
}

}  // namespace

YoloSegmenter::YoloSegmenter(const YoloOptions& options, const fs::path& classesFile, Backend backend)
    : YoloSegmenter(options, openNetwork(sourceOf(options, backend)), sourceOf(options, backend), classesFile) {}

YoloSegmenter::YoloSegmenter(const YoloOptions& options, OpenedNetwork opened, const NetworkSource& source,
                             const fs::path& classesFile)
    : options_(options.decoder),
      network_(std::move(opened.network)),
      input_px_(opened.input_px),
      model_(source.model.string()) {
  if (input_px_.empty()) {
    throw core::InputError(model_ + ": leaves the size of its input open; export it with a fixed one (imgsz=256,320 " +
                           "dynamic=False)");
  }
  // By running it: the shapes a file declares are optional, those that come out count.
  chooseOutputs(tryNetwork(*network_, blobOf(cv::Mat(input_px_, CV_8UC3, cv::Scalar::all(0))), source),
                namedClasses(classesFile, opened.classNames));
  labels_ = labelsFor(layout_, classesFile, model_, opened.classNames);
}

/// There may be more than the two that count.
void YoloSegmenter::chooseOutputs(const std::vector<cv::Mat>& outputs, std::optional<std::size_t> named) {
  std::size_t found = 0;
  for (std::size_t d = 0; d < outputs.size(); ++d) {
    for (std::size_t p = 0; p < outputs.size(); ++p) {
      const auto layout = YoloLayout::fromShapes(shapeOf(outputs[d]), shapeOf(outputs[p]), input_px_, named);
      if (!layout) continue;
      ++found;
      layout_ = *layout;
      detectionsIndex_ = d;
      prototypesIndex_ = p;
    }
  }
  if (found == 1) return;
  throw core::InputError(model_ + ": its outputs " + shapesText(outputs) + " are not those of a YOLO-seg network of " +
                         std::to_string(input_px_.width) + "x" + std::to_string(input_px_.height) +
                         " pixels (detections and mask prototypes); give a segmentation model such as yolov8n-seg or "
                         "yolov5n-seg, as its program exports it");
}

Segmenter::Result YoloSegmenter::segment(const SegmenterInput& input) {
  try {
    const Letterbox letterbox(input.color_bgr.size(), input_px_);
    const auto outputs = network_->infer(blobOf(letterbox.apply(input.color_bgr)));
    const cv::Mat& detections = outputs.at(detectionsIndex_);
    const cv::Mat& prototypes = outputs.at(prototypesIndex_);
    return {decodeYolo(detections, prototypes, layout_, letterbox, labels_, options_), {}};
  } catch (const YoloLayoutError& error) {
    throw core::InputError(model_ + ": " + error.what());
  } catch (const NetworkError&) {
  } catch (const cv::Exception&) {  // an image that is none
  }
  return {{}, {{"segmentation.network_failed", 1}}};
}

}  // namespace wardslam::segmentation
