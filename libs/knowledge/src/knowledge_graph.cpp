#include "wardslam/knowledge/knowledge_graph.h"

#include <algorithm>

#include "knowledge_reader.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::knowledge {
namespace {

template <class Value>
std::vector<std::string> keysOf(const std::map<std::string, Value>& map) {
  std::vector<std::string> keys;
  keys.reserve(map.size());
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

template <class Value>
const Value& find(const std::map<std::string, Value>& map, const std::string& name, const char* kind) {
  const auto found = map.find(name);
  if (found != map.end()) return found->second;
  throw core::InputError("the knowledge graph has no " + std::string(kind) + " '" + name + "'; the nearest is '" +
                         core::nearestName(name, keysOf(map)) + "'");
}

}  // namespace

KnowledgeGraph KnowledgeGraph::fromFile(const std::filesystem::path& file) {
  return fromConfig(core::ConfigNode::fromFile(file));
}

KnowledgeGraph KnowledgeGraph::fromConfig(const core::ConfigNode& root) { return KnowledgeReader(root).read(); }

std::vector<std::string> KnowledgeGraph::entities() const { return keysOf(entities_); }

std::vector<std::string> KnowledgeGraph::sets() const { return keysOf(contents_); }

const KnowledgeGraph::Entity& KnowledgeGraph::at(const std::string& entity) const {
  return find(entities_, entity, "entity");
}

Mobility KnowledgeGraph::mobility(const std::string& entity) const { return at(entity).mobility; }

bool KnowledgeGraph::canBeMovedBy(const std::string& entity, const std::string& byEntity) const {
  return holds(entity, kCanBeMovedBy, byEntity);
}

bool KnowledgeGraph::holds(const std::string& head, const std::string& relation, const std::string& tail) const {
  static_cast<void>(at(head));  // a misspelt name must not pass for "no"
  static_cast<void>(at(tail));
  return expanded_.count({head, relation, tail}) > 0;
}

Bond KnowledgeGraph::bond(const std::string& head, const std::string& relation, const std::string& tail) const {
  static_cast<void>(at(head));
  static_cast<void>(at(tail));
  const auto found = expanded_.find({head, relation, tail});
  return found == expanded_.end() ? Bond{0.0, 0.0} : found->second;
}

std::vector<Fact> KnowledgeGraph::factsAbout(const std::string& entity) const {
  static_cast<void>(at(entity));
  std::vector<Fact> about;
  for (const auto& [names, bond] : expanded_) {
    const auto& [head, relation, tail] = names;
    if (head == entity || tail == entity) about.push_back({head, relation, tail, bond});
  }
  return about;
}

const std::vector<std::string>& KnowledgeGraph::contents(const std::string& set) const {
  return find(contents_, set, "set");
}

const std::set<std::string>& KnowledgeGraph::members(const std::string& setOrEntity) const {
  return find(members_, setOrEntity, "entity or set");
}

const std::vector<std::string>& KnowledgeGraph::labels(const std::string& entity) const { return at(entity).labels; }

std::vector<std::string> KnowledgeGraph::entitiesOf(const std::string& label) const {
  std::vector<std::string> names;
  for (const auto& [name, entity] : entities_) {
    if (std::find(entity.labels.begin(), entity.labels.end(), label) != entity.labels.end()) names.push_back(name);
  }
  return names;
}

}  // namespace wardslam::knowledge
