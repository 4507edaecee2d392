#include "wardslam/segmentation/mask_rcnn_segmenter.h"

#include <opencv2/dnn.hpp>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

constexpr int kTrialWidth_px = 320;
constexpr int kTrialHeight_px = 240;

NetworkSource sourceOf(const MaskRcnnOptions& options, Backend backend) {
  NetworkSource source;
  source.model = options.model;
  source.graph = options.graph;
  source.backend = backend;
  source.outputs = {"detection_out_final", "detection_masks"};
  source.kind = "Mask R-CNN";
  source.key = "mask_rcnn.model";
  source.advice =
      "; give the frozen graph of a Mask R-CNN from the TensorFlow object detection API as mask_rcnn.model and "
      "OpenCV's "
      "description of it as mask_rcnn.graph";
  return source;
}

std::optional<int> classesOf(const std::vector<cv::Mat>& outputs) {
  return outputs.size() == 2 ? maskRcnnClasses(shapeOf(outputs[0]), shapeOf(outputs[1])) : std::nullopt;
}

}  // namespace

MaskRcnnSegmenter::MaskRcnnSegmenter(const MaskRcnnOptions& options, const fs::path& classesFile, Backend backend)
    : MaskRcnnSegmenter(options, openNetwork(sourceOf(options, backend)), sourceOf(options, backend), classesFile) {}

MaskRcnnSegmenter::MaskRcnnSegmenter(MaskRcnnOptions options, OpenedNetwork opened, const NetworkSource& source,
                                     const fs::path& classesFile)
    : options_(std::move(options)), network_(std::move(opened.network)) {
  const cv::Mat blank(kTrialHeight_px, kTrialWidth_px, CV_8UC3, cv::Scalar::all(0));
  const auto outputs = tryNetwork(*network_, blobOf(blank), source);
  const auto classes = classesOf(outputs);
  if (!classes) {
    throw core::InputError(source.model.string() + ": its outputs " + shapesText(outputs) +
                           " are not those of a Mask R-CNN (detections and masks)" + source.advice);
  }
  labels_ = LabelMap::forNetwork(*classes, classesFile, source.model.string(), opened.classNames);
}

Segmenter::Result MaskRcnnSegmenter::segment(const SegmenterInput& input) {
  try {
    const auto outputs = network_->infer(blobOf(input.color_bgr));
    if (classesOf(outputs)) {
      return {decodeMaskRcnn(outputs[0], outputs[1], labels_, input.color_bgr.size(), options_.decoder), {}};
    }
  } catch (const NetworkError&) {
  } catch (const cv::Exception&) {  // an image that is none
  }
  return {{}, {{"segmentation.network_failed", 1}}};
}

cv::Mat MaskRcnnSegmenter::blobOf(const cv::Mat& color_bgr) const {
  const cv::Size size_px(options_.input_width_px > 0 ? options_.input_width_px : color_bgr.cols,
                         options_.input_height_px > 0 ? options_.input_height_px : color_bgr.rows);
  constexpr bool kSwapToRgb = true;
  return cv::dnn::blobFromImage(color_bgr, 1.0, size_px, {}, kSwapToRgb);
}

}  // namespace wardslam::segmentation
