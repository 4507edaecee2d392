#include "wardslam/knowledge/motion_rules.h"

#include <string>
#include <vector>

#include "wardslam/knowledge/knowledge_graph.h"

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
        for (const core::ClassId by : classesOf(fact.tail, graph, labels)) movers_[c].set(by);
      }
    }
  }
}

}  // namespace wardslam::knowledge
