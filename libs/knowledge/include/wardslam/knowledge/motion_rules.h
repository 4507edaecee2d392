#pragma once

#include <array>
#include <bitset>
#include <map>
#include <utility>

#include "wardslam/core/label_space.h"
#include "wardslam/core/segmentation.h"
#include "wardslam/knowledge/knowledge_graph.h"

namespace wardslam::knowledge {

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

  /// How likely, and from how near; strength 0 where it cannot. Of several entities a label stands for, the strongest
  /// and the farthest reaching.
  [[nodiscard]] Bond bond(core::ClassId c, core::ClassId by) const;

  [[nodiscard]] const ClassSet& moving() const { return moving_; }
  [[nodiscard]] const ClassSet& movable() const { return movable_; }
  /// Who can move it.
  [[nodiscard]] const ClassSet& movers(core::ClassId c) const { return movers_[c]; }

 private:
  void add(core::ClassId c, core::ClassId by, const Bond& bond);

  ClassSet moving_;
  ClassSet movable_;
  std::array<ClassSet, 256> movers_;
  std::map<std::pair<core::ClassId, core::ClassId>, Bond> bonds_;
};

}  // namespace wardslam::knowledge
