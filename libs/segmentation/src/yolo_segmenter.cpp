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

}  // namespace

YoloSegmenter::YoloSegmenter(const YoloOptions& options, const fs::path& classesFile, Backend backend)
    : YoloSegmenter(options, openNetwork(sourceOf(options, backend)), sourceOf(options, backend), classesFile) {}

YoloSegmenter::YoloSegmenter(const YoloOptions& options, OpenedNetwork opened, const NetworkSource& source,
                             const fs::path& classesFile)
    : options_(options.decoder), network_(std::move(opened.network)), input_px_(opened.input_px) {
  const auto fail = [&](const std::string& what) { throw core::InputError(source.model.string() + ": " + what); };
  if (input_px_.empty()) {
    fail("leaves the size of its input open; export it with a fixed one (imgsz=256,320 dynamic=False)");
  }
  // By running it: the shapes a file declares are optional, those that come out count.
  const auto outputs = tryNetwork(*network_, blobOf(cv::Mat(input_px_, CV_8UC3, cv::Scalar::all(0))), source);
  std::optional<YoloLayout> layout;
  if (outputs.size() == 2) {
    detectionsIndex_ = outputs[0].dims == 3 ? 0 : 1;
    layout = YoloLayout::fromShapes(shapeOf(outputs[detectionsIndex_]), shapeOf(outputs[1 - detectionsIndex_]));
  }
  if (!layout) {
    fail("its outputs " + shapesText(outputs) +
         " are not those of a YOLO-seg network (detections and mask prototypes); give a segmentation model such as "
         "yolov8n-seg or yolov5n-seg");
  }
  layout_ = *layout;
  labels_ = LabelMap::forNetwork(layout_.classes, classesFile, source.model.string());
}

Segmenter::Result YoloSegmenter::segment(const SegmenterInput& input) {
  try {
    const Letterbox letterbox(input.color_bgr.size(), input_px_);
    const auto outputs = network_->infer(blobOf(letterbox.apply(input.color_bgr)));
    const cv::Mat& detections = outputs.at(detectionsIndex_);
    const cv::Mat& prototypes = outputs.at(1 - detectionsIndex_);
    return {decodeYolo(detections, prototypes, layout_, letterbox, labels_, options_), {}};
  } catch (const NetworkError&) {
  } catch (const cv::Exception&) {  // an image that is none
  }
  return {{}, {{"segmentation.network_failed", 1}}};
}

}  // namespace wardslam::segmentation
