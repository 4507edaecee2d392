#include "wardslam/knowledge/motion_rules.h"

#include <algorithm>
#include <string>
#include <vector>

namespace wardslam::knowledge {
namespace {

std::vector<core::ClassId> classesOf(const std::string& entity, const KnowledgeGraph& graph,
                                     const core::LabelSpace& labels) {
  std::vector<core::ClassId> classes;
  for (const std::string& label : graph.labels(entity)) {
    if (const auto id = labels.find(label)) classes.push_back(*id);
  }
  return classes;
}

}  // namespace

MotionRules::MotionRules(const KnowledgeGraph& graph, const core::LabelSpace& labels) {
  for (const std::string& entity : graph.entities()) {
    for (const core::ClassId c : classesOf(entity, graph, labels)) {
      moving_[c] = graph.isMoving(entity);
      movable_[c] = graph.isMovable(entity);
    }
    for (const Fact& fact : graph.factsAbout(entity)) {
      if (fact.head != entity || fact.relation != kCanBeMovedBy) continue;
      for (const core::ClassId c : classesOf(entity, graph, labels)) {
        for (const core::ClassId by : classesOf(fact.tail, graph, labels)) add(c, by, fact.bond);
      }
    }
  }
}

void MotionRules::add(core::ClassId c, core::ClassId by, const Bond& bond) {
  movers_[c].set(by);
  Bond& most = bonds_.emplace(std::pair(c, by), bond).first->second;
  most.strength = std::max(most.strength, bond.strength);
  most.reach_m = std::max(most.reach_m, bond.reach_m);
}

Bond MotionRules::bond(core::ClassId c, core::ClassId by) const {
  const auto found = bonds_.find({c, by});
  return found == bonds_.end() ? Bond{0.0, 0.0} : found->second;
}

}  // namespace wardslam::knowledge
