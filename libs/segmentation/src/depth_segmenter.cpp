#include "wardslam/segmentation/depth_segmenter.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "depth_decoder.h"
#include "depth_instances.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/segmentation/depth_channels.h"
#include "wardslam/segmentation/instance_images.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

constexpr double kMinMeasured = 0.05;  ///< Of the image: with less depth nothing is to be seen.
constexpr int kMaxClasses = 256;

NetworkSource sourceOf(const DepthOptions& options, Backend backend) {
  NetworkSource source;
  source.model = fs::exists(options.model) ? fs::path(options.model) : core::findDataFile(options.model);
  source.backend = backend;
  source.channels = kDepthChannels;
  source.kind = "depth";
  source.key = "depth.model";
  return source;
}

fs::path labelFileOf(const fs::path& classesFile, const fs::path& model) {
  if (!classesFile.empty()) return classesFile;
  auto beside = model;
  beside.replace_extension(".yaml");
  if (fs::exists(beside)) return beside;
  throw core::InputError(beside.string() +
                         ": not found; a depth network needs its label file beside it, or one named "
                         "in segmentation.classes");
}

int indexOfPeople(const LabelMap& labels, int classes) {
  const auto person = labels.labels().find("person");
  for (int i = 0; person && i < classes; ++i) {
    if (labels.classOf(i) == *person) return i;
  }
  return -1;
}

/// A picture of the network's input as an image again.
cv::Mat toImage(const cv::Mat& picture, const Letterbox& letterbox) {
  cv::Mat image;
  cv::resize(picture(letterbox.content_px()), image, letterbox.image_px(), 0.0, 0.0, cv::INTER_NEAREST);
  return image;
}

/// Sets the confidence of each instance to the mean probability of its pixels.
void tellConfidence(std::vector<core::Instance>& instances, const cv::Mat& instanceIds, const cv::Mat& probability) {
  std::vector<double> sums(instances.size() + 1, 0.0);
  std::vector<double> pixels(instances.size() + 1, 0.0);
  for (int v = 0; v < instanceIds.rows; ++v) {
    const auto* id = instanceIds.ptr<std::uint16_t>(v);
    const auto* p = probability.ptr<float>(v);
    for (int u = 0; u < instanceIds.cols; ++u) {
      sums[id[u]] += static_cast<double>(p[u]);
      pixels[id[u]] += 1.0;
    }
  }
  for (core::Instance& instance : instances) {
    instance.confidence = static_cast<float>(sums[instance.id] / std::max(pixels[instance.id], 1.0));
  }
}

}  // namespace

DepthSegmenter::DepthSegmenter(const DepthOptions& options, const fs::path& classesFile, Backend backend)
    : DepthSegmenter(options, openNetwork(sourceOf(options, backend)), sourceOf(options, backend), classesFile) {}

DepthSegmenter::DepthSegmenter(const DepthOptions& options, OpenedNetwork opened, const NetworkSource& source,
                               const fs::path& classesFile)
    : options_(options), network_(std::move(opened.network)), input_px_(opened.input_px) {
  const auto fail = [&](const std::string& what) { throw core::InputError(source.model.string() + ": " + what); };
  if (input_px_.empty()) fail("leaves the size of its input open; export it with a fixed one");
  const auto outputs = tryNetwork(
      *network_, cv::Mat({1, kDepthChannels, input_px_.height, input_px_.width}, CV_32F, cv::Scalar(0)), source);
  scoresShape_ = outputs.empty() ? std::vector<int>() : shapeOf(outputs.front());
  const bool isSound = scoresShape_.size() == 4 && scoresShape_[0] == 1 && scoresShape_[1] <= kMaxClasses &&
                       *std::min_element(scoresShape_.begin(), scoresShape_.end()) > 0;
  if (!isSound) {
    fail("its outputs " + shapesText(outputs) + " are not those of a depth network (scores of each class per pixel)");
  }
  labels_ = LabelMap::forNetwork(scoresShape_[1], labelFileOf(classesFile, source.model), source.model.string());
  person_ = indexOfPeople(labels_, scoresShape_[1]);
}

Segmenter::Result DepthSegmenter::segment(const SegmenterInput& input) {
  const bool isRegistered = input.depth_m.size() == input.color_bgr.size() && input.depth_m.type() == CV_32FC1;
  const auto pixels = static_cast<double>(input.depth_m.total());
  if (!isRegistered || pixels == 0.0 || cv::countNonZero(input.depth_m > 0.0F) < kMinMeasured * pixels) {
    return {{}, {{"segmentation.no_depth", 1}}};
  }
  try {
    return {see(input), {}};
  } catch (const NetworkError&) {
  } catch (const cv::Exception&) {  // a picture that is none
  }
  return {{}, {{"segmentation.network_failed", 1}}};
}

core::Segmentation DepthSegmenter::see(const SegmenterInput& input) {
  const Letterbox letterbox(input.depth_m.size(), input_px_);
  const DepthPicture picture = fitDepth(input.depth_m, input.camera, letterbox);
  const auto outputs = network_->infer(depthChannels(picture));
  if (outputs.empty() || shapeOf(outputs.front()) != scoresShape_)
    throw NetworkError("puts out other shapes than before");
  const PixelClasses seen = decodeDepthScores(outputs.front(), picture.depth_m, person_,
                                              {options_.person_measured, options_.person_unmeasured});
  const cv::Mat classIds = labels_.apply(seen.indices);
  const double shrinkage = letterbox.scaleX() * letterbox.scaleY();
  const int minArea_px = std::max(1, static_cast<int>(options_.min_region_px * shrinkage));
  const core::ClassId person = labels_.classOf(person_);
  const cv::Mat instanceIds = labelByDepth(classIds, picture.depth_m, {picture.fx_px, minArea_px, person});

  core::Segmentation segmentation;
  segmentation.classIds = toImage(classIds, letterbox);
  segmentation.instanceIds = toImage(instanceIds, letterbox);
  segmentation.instances = listInstances(segmentation.classIds, segmentation.instanceIds);
  tellConfidence(segmentation.instances, instanceIds, seen.probability);
  return segmentation;
}

}  // namespace wardslam::segmentation
