#include "wardslam/filters/semantic_dynamic_filter.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/imgproc.hpp>

#include "wardslam/core/annotation.h"
#include "wardslam/filters/motion_annotation.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/segmentation/async_segmenter.h"

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

cv::Mat widen(const cv::Mat& ids, int margin_px) {
  if (margin_px == 0) return ids;
  cv::Mat widened;
  const int side = 2 * margin_px + 1;
  cv::dilate(ids, widened, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return widened;
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
  core::readOptions(parameters, options_);
  check(options_, parameters);
  if (!context.segmenter) parameters.fail("SemanticDynamicFilter needs a segmenter; give masks or a network");
  if (!context.knowledge) parameters.fail("SemanticDynamicFilter needs a knowledge graph; give one");
  if (context.deterministic && !options_.masks.isRepeatable()) {
    parameters.child("mode").fail(
        "in a deterministic run masks cannot come just when they are ready; give latency_frames (3, say) or mode wait");
  }
  masks_ = makeMaskFeed(options_.masks, context.segmenter);
  rules_.emplace(*context.knowledge, context.segmenter->labelSpace());
  test_.emplace(*rules_, options_.test);
  movingIds_ = tableOfMoving(*rules_);
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
  markMotion(frame);
}

std::string SemanticDynamicFilter::parameters(int indent) const { return core::writeOptions(options_, indent); }

void SemanticDynamicFilter::markMotion(core::Frame& frame) {
  const cv::Mat& classIds = frame.segmentation.classIds;
  cv::Mat moving;
  cv::LUT(classIds, movingIds_, moving);
  const cv::Mat widened = widen(moving, options_.margin_px);
  // Where two kinds of moving things touch, each keeps its own pixels.
  cv::Mat tested = widened.clone();
  classIds.copyTo(tested, (widened == 0) | (moving != 0));

  test_->setImage(tested);
  test_->mark(frame.features.keypoints);
  if (options_.annotate && frame.observation) annotate(frame, widened);
}

void SemanticDynamicFilter::annotate(core::Frame& frame, const cv::Mat& movingMask) {
  const auto& range = frame.observation->rangeImage;
  if (range.rows() != movingMask.rows || range.cols() != movingMask.cols) {
    ++frame.events["filters.annotation_size"];
    return;
  }
  core::annotate(*frame.observation, motionLabels(frame.segmentation, movingMask, *rules_, *test_));
}

}  // namespace wardslam::filters
