#include "wardslam/segmentation/semantic_segmenter.h"

#include <opencv2/dnn.hpp>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;
using Normalisation = SemanticOptions::Normalisation;

NetworkSource sourceOf(const SemanticOptions& options, Backend backend) {
  NetworkSource source;
  source.model = options.model;
  source.graph = options.graph;
  if (!options.output.empty()) source.outputs = {options.output};
  source.backend = backend;
  source.kind = "semantic";
  source.key = "semantic.model";
  return source;
}

cv::Size chooseInput(const SemanticOptions& options, const cv::Size& declared_px, const fs::path& model) {
  if (options.input_width_px > 0 && options.input_height_px > 0) {
    return {options.input_width_px, options.input_height_px};
  }
  if (!declared_px.empty()) return declared_px;
  throw core::InputError(model.string() +
                         ": does not tell the size of its input; set semantic.input_width and semantic.input_height");
}

std::optional<SemanticLayout> layoutOf(const std::vector<cv::Mat>& outputs, const cv::Size& input_px) {
  return outputs.empty() ? std::nullopt : SemanticLayout::fromShape(shapeOf(outputs.front()), input_px);
}

LabelMap labelsFor(const SemanticLayout& layout, const fs::path& classesFile, const fs::path& model,
                   const std::vector<std::string>& names) {
  if (layout.kind != SemanticLayout::Kind::ClassMap) {
    return LabelMap::forNetwork(layout.classes, classesFile, model.string(), names);
  }
  if (!classesFile.empty()) return LabelMap::fromFile(classesFile);
  if (!names.empty()) return LabelMap::fromNames(names, model.string());
  throw core::InputError(model.string() +
                         ": puts out class numbers without telling how many there are; name them in a label file "
                         "(segmentation.classes)");
}

}  // namespace

cv::Mat normalised(const cv::Mat& image_bgr, Normalisation normalisation) {
  constexpr bool kSwapToRgb = true;
  switch (normalisation) {
    case Normalisation::None:
      return cv::dnn::blobFromImage(image_bgr, 1.0, {}, {}, kSwapToRgb);
    case Normalisation::ZeroToOne:
      return cv::dnn::blobFromImage(image_bgr, 1.0 / 255.0, {}, {}, kSwapToRgb);
    case Normalisation::MinusOneToOne:
      return cv::dnn::blobFromImage(image_bgr, 1.0 / 127.5, {}, cv::Scalar::all(127.5), kSwapToRgb);
    case Normalisation::ImageNet:
      break;
  }
  // Mean and deviation of ImageNet's red, green and blue, as fractions of full brightness.
  const cv::Scalar mean(0.485, 0.456, 0.406);
  const double deviation[] = {0.229, 0.224, 0.225};
  cv::Mat blob = cv::dnn::blobFromImage(image_bgr, 1.0 / 255.0, {}, mean * 255.0, kSwapToRgb);
  for (int channel = 0; channel < 3; ++channel) {
    cv::Mat plane(image_bgr.size(), CV_32F, blob.ptr<float>(0, channel));
    plane /= deviation[channel];
  }
  return blob;
}

SemanticSegmenter::SemanticSegmenter(const SemanticOptions& options, const fs::path& classesFile, Backend backend)
    : SemanticSegmenter(options, openNetwork(sourceOf(options, backend)), sourceOf(options, backend), classesFile) {}

SemanticSegmenter::SemanticSegmenter(const SemanticOptions& options, OpenedNetwork opened, const NetworkSource& source,
                                     const fs::path& classesFile)
    : options_(options),
      network_(std::move(opened.network)),
      input_px_(chooseInput(options, opened.input_px, source.model)) {
  const cv::Mat blank(input_px_, CV_8UC3, cv::Scalar::all(0));
  const auto outputs = tryNetwork(*network_, normalised(blank, options_.normalisation), source);
  const auto layout = layoutOf(outputs, input_px_);
  if (!layout) {
    throw core::InputError(source.model.string() + ": its outputs " + shapesText(outputs) +
                           " are not those of a semantic network (scores or a number per pixel, of one image)");
  }
  layout_ = *layout;
  labels_ = labelsFor(layout_, classesFile, source.model, opened.classNames);
}

Segmenter::Result SemanticSegmenter::segment(const SegmenterInput& input) {
  try {
    const Letterbox letterbox(input.color_bgr.size(), input_px_);
    const auto outputs = network_->infer(normalised(letterbox.apply(input.color_bgr), options_.normalisation));
    return {decodeSemantic(outputs.at(0), layout_, letterbox, labels_, options_.min_region_px), {}};
  } catch (const NetworkError&) {
  } catch (const cv::Exception&) {  // an image that is none
  }
  return {{}, {{"segmentation.network_failed", 1}}};
}

}  // namespace wardslam::segmentation
