#include "semantic_dynamic_filter.h"

#include <algorithm>
#include <map>
#include <opencv2/imgproc.hpp>

#include "moved_options.h"
#include "wardslam/core/nearest_pixel.h"
#include "wardslam/features/semantic_descriptor.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/masks/async_segmenter.h"

namespace wardslam::filters {

IMPLEMENTS_MRPT_OBJECT(SemanticDynamicFilter, ObservationFilter, wardslam::filters)

namespace {

cv::Mat tableOfMoving(const knowledge::MotionRules& rules) {
  cv::Mat ids(1, 256, CV_8UC1, cv::Scalar(0));
  for (int c = 1; c < 256; ++c) {
    const auto id = static_cast<core::ClassId>(c);
    if (rules.isMoving(id)) ids.at<core::ClassId>(c) = id;
  }
  return ids;
}

cv::Mat tableOfLabels(const knowledge::MotionRules& rules) {
  using core::bitOf;
  using core::PixelLabel;
  cv::Mat labels(1, 256, CV_8UC1, cv::Scalar(0));
  for (int c = 1; c < 256; ++c) {
    const auto id = static_cast<core::ClassId>(c);
    auto& bits = labels.at<std::uint8_t>(c);
    bits = rules.isMoving(id) ? bitOf(PixelLabel::Person) : bitOf(PixelLabel::Thing);
    if (rules.isMovable(id)) bits = static_cast<std::uint8_t>(bits | bitOf(PixelLabel::Movable));
  }
  return labels;
}

cv::Mat widen(const cv::Mat& ids, int margin_px) {
  if (margin_px == 0) return ids.clone();
  cv::Mat widened;
  const int side = 2 * margin_px + 1;
  cv::dilate(ids, widened, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return widened;
}

/// The box of an instance with a margin around, cut at the image border.
cv::Rect boxAround(const core::Instance& instance, int margin_px, const cv::Size& size) {
  const cv::Point margin(margin_px, margin_px);
  return cv::Rect(instance.box_px.tl() - margin, instance.box_px.br() + margin) & cv::Rect({}, size);
}

void check(const SemanticDynamicOptions& options, const core::ConfigNode& parameters) {
  const auto& [n, delta] = options.test;
  if (n % 2 == 0) parameters.child("n").fail(std::to_string(n) + " is even; an odd number is needed");
  if (delta >= n * n) {
    parameters.child("delta").fail(std::to_string(delta) + " can never be exceeded by the " + std::to_string(n * n) +
                                   " pixels of the square; give less");
  }
}

}  // namespace

void SemanticDynamicFilter::initialize(const core::ConfigNode& parameters, const FilterContext& context) {
  refuseMovedOptions(parameters);
  core::readOptions(parameters, options_);
  check(options_, parameters);
  if (!context.segmenter) parameters.fail("SemanticDynamicFilter needs a segmenter; give masks or a network");
  if (!context.knowledge) parameters.fail("SemanticDynamicFilter needs a knowledge graph; give one");
  if (context.deterministic && !options_.masks.isRepeatable()) {
    parameters.child("mode").fail(
        "in a deterministic run masks cannot come just when they are ready; give latency_frames (3, say) or mode wait");
  }
  options_.masks.keepsIds = options_.rule == SemanticDynamicOptions::Rule::Observed;  // evidence is gathered by id
  masks_ = masks::makeMaskFeed(options_.masks, context.segmenter);
  rules_.emplace(*context.knowledge, context.segmenter->labelSpace());
  test_.emplace(*rules_, options_.test);
  judge_.emplace(*rules_, options_.judge);
  movingIds_ = tableOfMoving(*rules_);
  classLabels_ = tableOfLabels(*rules_);
}

void SemanticDynamicFilter::begin(const core::Frame& frame) {
  masks_->begin(frame);
  isBegun_ = true;
}

void SemanticDynamicFilter::apply(core::Frame& frame) {
  if (!isBegun_) begin(frame);
  isBegun_ = false;
  masks_->fill(frame);
  if (frame.segmentation.empty()) {
    ++frame.events["filters.no_segmentation"];
    return;
  }
  frame.features.semanticDescriptors =
      std::make_shared<features::SemanticDescriptors>(frame.segmentation.classIds, options_.test.n);
  cv::Mat labels;
  cv::LUT(frame.segmentation.classIds, classLabels_, labels);
  core::addLabels(frame, labels);
  cv::Mat movers;
  cv::LUT(frame.segmentation.classIds, movingIds_, movers);
  const bool hasInstances = !frame.segmentation.instanceIds.empty();
  const bool isObserved = options_.rule == SemanticDynamicOptions::Rule::Observed && hasInstances;
  isObserved ? markByObservation(frame, movers) : markByPaper(frame, movers);
}

void SemanticDynamicFilter::end(const core::Frame& frame, const std::optional<Eigen::Isometry3d>& T_map_cam) {
  if (options_.rule != SemanticDynamicOptions::Rule::Observed) return;
  learning_.start([this, frame, T_map_cam] { judge_->observe(frame, T_map_cam); });
}

std::string SemanticDynamicFilter::parameters(int indent) const { return core::writeOptions(options_, indent); }

void SemanticDynamicFilter::markByObservation(core::Frame& frame, const cv::Mat& movers) {
  if (learning_.isStarted()) learning_.take();
  const cv::Mat& instanceIds = frame.segmentation.instanceIds;
  cv::Mat moves = setTestImage(frame.segmentation.classIds, movers) != 0;
  cv::Mat rests(movers.size(), CV_8UC1, cv::Scalar(0));
  cv::Mat suspected = rests.clone();
  std::map<std::uint16_t, float> staticProbability;  // by instance
  for (const Verdict& verdict : judge_->judge(frame, movers)) {
    const cv::Rect box = boxAround(verdict.instance, options_.margin_px, movers.size());
    if (box.empty()) continue;
    const cv::Mat whole = instanceIds(box) == verdict.instance.id;
    if (verdict.finding == Verdict::Finding::Rests) rests(box) |= whole;
    if (verdict.finding == Verdict::Finding::Moves) moves(box) |= widen(whole, options_.margin_px);
    if (verdict.finding == Verdict::Finding::Suspected) suspected(box) |= whole;
    staticProbability[verdict.instance.id] = static_cast<float>(1.0 - verdict.probabilityOfMotion());
  }
  // What is only suspected, and things too small to be an instance, are left to the paper's rule.
  const cv::Mat dynamic = moves | test_->mask(rests | moves);
  core::addDynamic(frame, dynamic);
  core::addMayMove(frame, suspected);
  for (core::Keypoint& keypoint : frame.features.keypoints) {
    const cv::Point pixel = core::nearestPixel(keypoint.raw_px, dynamic.size());
    if (dynamic.at<std::uint8_t>(pixel) != 0) keypoint.motion = core::Motion::Dynamic;
    const auto found = staticProbability.find(instanceIds.at<std::uint16_t>(pixel));
    if (found != staticProbability.end())
      keypoint.staticProbability = std::min(keypoint.staticProbability, found->second);
  }
}

void SemanticDynamicFilter::markByPaper(core::Frame& frame, const cv::Mat& movers) {
  setTestImage(frame.segmentation.classIds, movers);
  test_->mark(frame.features.keypoints);
  core::addDynamic(frame, test_->mask());
}

cv::Mat SemanticDynamicFilter::setTestImage(const cv::Mat& classIds, const cv::Mat& movers) {
  // Where two kinds of moving things touch, each keeps its own pixels.
  const cv::Mat widened = widen(movers, options_.margin_px);
  cv::Mat tested = widened.clone();
  classIds.copyTo(tested, (widened == 0) | (movers != 0));
  test_->setImage(tested);
  return widened;
}

}  // namespace wardslam::filters
