#pragma once

#include "wardslam/core/options.h"
#include "wardslam/core/segmentation.h"
#include "wardslam/knowledge/knowledge_graph.h"

/// A small ward for tests: a person can move a cup and a chair, a dog only the ball, nobody the bed.
namespace wardslam::ward {

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

}  // namespace wardslam::ward
