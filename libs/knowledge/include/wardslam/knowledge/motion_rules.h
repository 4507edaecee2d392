#pragma once

#include <array>
#include <bitset>

#include "wardslam/core/label_space.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::knowledge {

class KnowledgeGraph;

/// A set of class ids: bit i stands for class i.
using ClassSet = std::bitset<256>;

/// What a KnowledgeGraph says about motion, as tables over the class ids of one label space, to be asked per pixel.
///
/// Where a label stands for several entities, "can" means that one of them can: a person may be a nurse. Classes the
/// graph does not know, unclassified (0) among them, are static.
class MotionRules {
 public:
  MotionRules(const KnowledgeGraph& graph, const core::LabelSpace& labels);

  [[nodiscard]] bool isMoving(core::ClassId c) const { return moving_[c]; }
  [[nodiscard]] bool isMovable(core::ClassId c) const { return movable_[c]; }
  [[nodiscard]] bool canBeMovedBy(core::ClassId c, core::ClassId by) const { return movers_[c][by]; }

  [[nodiscard]] const ClassSet& moving() const { return moving_; }
  [[nodiscard]] const ClassSet& movable() const { return movable_; }
  /// Who can move it.
  [[nodiscard]] const ClassSet& movers(core::ClassId c) const { return movers_[c]; }

 private:
  ClassSet moving_;
  ClassSet movable_;
  std::array<ClassSet, 256> movers_;
};

}  // namespace wardslam::knowledge
