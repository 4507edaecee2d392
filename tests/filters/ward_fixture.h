#pragma once

#include <memory>
#include <string>
#include <utility>

#include "wardslam/core/label_space.h"
#include "wardslam/filters/observation_filter.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/segmentation/async_segmenter.h"

/// A small ward for tests: a person can move a cup and a chair, a dog only the ball, nobody the bed.
namespace wardslam::filters::ward {

inline constexpr core::ClassId kPerson = 1;
inline constexpr core::ClassId kDog = 17;
inline constexpr core::ClassId kBall = 33;
inline constexpr core::ClassId kCup = 42;
inline constexpr core::ClassId kChair = 57;
inline constexpr core::ClassId kBed = 60;

inline knowledge::KnowledgeGraph graph() {
  return knowledge::KnowledgeGraph::fromConfig(core::ConfigNode::fromText(R"(
entities:
  {nurse: [person], pet: [dog], cup: [cup], chair: [chair], ball: [sports ball], vase: [vase], bed: [bed]}
sets: {moving: [nurse, pet], movable: [cup, chair, ball, vase], static: [bed]}
relations: [can_be_moved_by]
facts:
  - [cup, can_be_moved_by, nurse]
  - [chair, can_be_moved_by, nurse]
  - [ball, can_be_moved_by, moving]
)"));
}

/// Puts out what it was told to, and counts the questions.
class FakeSegmenter : public segmentation::Segmenter {
 public:
  explicit FakeSegmenter(std::shared_ptr<Result> result) : result_(std::move(result)) {}

  Result segment(const cv::Mat&, double stamp_s) override {
    Result result = *result_;
    result.events["fake.stamp_" + std::to_string(static_cast<int>(stamp_s))] = 1;
    return result;
  }
  const core::LabelSpace& labelSpace() const override { return labels_; }

 private:
  std::shared_ptr<Result> result_;
  core::LabelSpace labels_ = core::LabelSpace::coco();
};

inline FilterContext context(std::shared_ptr<segmentation::Segmenter::Result> result) {
  FilterContext context;
  context.segmenter =
      std::make_shared<segmentation::AsyncSegmenter>(std::make_unique<FakeSegmenter>(std::move(result)));
  context.knowledge = std::make_shared<knowledge::KnowledgeGraph>(graph());
  return context;
}

inline core::Keypoint keypointAt(float x, float y) {
  core::Keypoint keypoint;
  keypoint.raw_px = {x, y};
  return keypoint;
}

}  // namespace wardslam::filters::ward
