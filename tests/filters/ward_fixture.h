#pragma once

#include <memory>
#include <string>
#include <utility>

#include "support/small_ward.h"
#include "wardslam/core/label_space.h"
#include "wardslam/filters/observation_filter.h"
#include "wardslam/masks/async_segmenter.h"

/// The small ward (support/small_ward.h) with a segmenter for filters.
namespace wardslam::filters::ward {

using namespace wardslam::ward;

/// Puts out what it was told to, and counts the questions.
class FakeSegmenter : public segmentation::Segmenter {
 public:
  explicit FakeSegmenter(std::shared_ptr<Result> result) : result_(std::move(result)) {}

  Result segment(const segmentation::SegmenterInput& input) override {
    Result result = *result_;
    result.events["fake.stamp_" + std::to_string(static_cast<int>(input.stamp_s))] = 1;
    return result;
  }
  const core::LabelSpace& labelSpace() const override { return labels_; }

 private:
  std::shared_ptr<Result> result_;
  core::LabelSpace labels_ = core::LabelSpace::coco();
};

inline FilterContext context(std::shared_ptr<segmentation::Segmenter::Result> result) {
  FilterContext context;
  context.segmenter = std::make_shared<masks::AsyncSegmenter>(std::make_unique<FakeSegmenter>(std::move(result)));
  context.knowledge = std::make_shared<knowledge::KnowledgeGraph>(graph());
  return context;
}

inline core::Keypoint keypointAt(float x, float y) {
  core::Keypoint keypoint;
  keypoint.raw_px = {x, y};
  return keypoint;
}

}  // namespace wardslam::filters::ward
