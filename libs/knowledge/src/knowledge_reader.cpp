#include "knowledge_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "wardslam/core/nearest_name.h"

namespace wardslam::knowledge {
namespace {

using core::ConfigNode;

constexpr std::array<std::pair<const char*, Mobility>, 3> kMobilitySets = {
    {{"moving", Mobility::Moving}, {"movable", Mobility::Movable}, {"static", Mobility::Static}}};

std::string textOf(const ConfigNode& node) {
  std::string text;
  if (node.exists() && node.yaml().IsScalar()) text = node.yaml().as<std::string>();
  if (text.empty()) node.fail("a name is expected here");
  return text;
}

std::vector<ConfigNode> itemsOf(const ConfigNode& list) {
  std::vector<ConfigNode> items;
  if (!list.exists()) return items;
  if (!list.yaml().IsSequence()) list.fail("a list ([a, b, c]) is expected here");
  for (std::size_t i = 0; i < list.yaml().size(); ++i) items.push_back(list.item(i));
  return items;
}

std::vector<std::string> namesIn(const ConfigNode& list) {
  std::vector<std::string> names;
  for (const ConfigNode& item : itemsOf(list)) names.push_back(textOf(item));
  return names;
}

struct Entry {
  std::string name;
  ConfigNode key;
  ConfigNode value;
};

/// Unlike a look-up by key, keeps what the file has twice.
std::vector<Entry> entriesOf(const ConfigNode& map) {
  if (!map.exists() || !map.yaml().IsMap()) map.fail("a mapping (name: [...]) is expected here");
  std::vector<Entry> entries;
  for (const auto& pair : map.yaml()) {
    const auto name = textOf({pair.first, map.file(), map.key()});
    const std::string path = map.key() + "." + name;
    entries.push_back({name, {pair.first, map.file(), path}, {pair.second, map.file(), path}});
  }
  return entries;
}

std::string labelConflict(const std::string& label, const std::string& first, const std::string& second) {
  return "label '" + label + "' stands for '" + first + "' and '" + second +
         "', of which one moves otherwise than the other; give it to one of them";
}

}  // namespace

KnowledgeGraph KnowledgeReader::read() {
  root_.requireKeys({"entities", "sets", "relations", "facts"});
  readEntities();
  readSets();
  assignMobility();
  checkLabels();
  readRelations();
  readFacts();
  return std::move(graph_);
}

void KnowledgeReader::readEntities() {
  for (const auto& [name, key, value] : entriesOf(root_.child("entities"))) {
    claimName(name, key);
    graph_.entities_[name].labels = namesIn(value);
    graph_.members_[name] = {name};
    entityNodes_.emplace(name, key);
  }
}

void KnowledgeReader::readSets() {
  for (const auto& [name, key, value] : entriesOf(root_.child("sets"))) {
    claimName(name, key);
    setNodes_.emplace(name, value);
  }
  for (const auto& [name, node] : setNodes_) {
    Names path;
    expand(name, path);
  }
}

const std::set<std::string>& KnowledgeReader::expand(const std::string& name, Names& path) {
  if (const auto done = graph_.members_.find(name); done != graph_.members_.end()) return done->second;

  const ConfigNode& node = setNodes_.at(name);
  const auto seen = std::find(path.begin(), path.end(), name);
  if (seen != path.end()) {
    std::string circle;
    for (auto it = seen; it != path.end(); ++it) circle.append(*it).append(" > ");
    node.fail("the sets contain each other in a circle: " + circle + name);
  }
  path.push_back(name);
  std::set<std::string> members;
  graph_.contents_[name] = namesIn(node);
  for (const ConfigNode& item : itemsOf(node)) {
    const std::string member = textOf(item);
    requireKnown(member, item);
    const auto& inner = expand(member, path);
    members.insert(inner.begin(), inner.end());
  }
  path.pop_back();
  return graph_.members_[name] = std::move(members);
}

void KnowledgeReader::assignMobility() {
  for (auto& [name, entity] : graph_.entities_) {
    const char* first = nullptr;
    for (const auto& [set, mobility] : kMobilitySets) {
      if (setNodes_.count(set) == 0 || graph_.members_.at(set).count(name) == 0) continue;
      if (first != nullptr) {
        entityNodes_.at(name).fail("'" + name + "' is in the sets '" + first + "' and '" + set + "'; keep one of them");
      }
      first = set;
      entity.mobility = mobility;
    }
    if (first == nullptr) {
      entityNodes_.at(name).fail("'" + name + "' is in none of the sets moving, movable, static; put it into one");
    }
  }
}

void KnowledgeReader::checkLabels() const {
  std::map<std::string, std::string> owners;
  for (const auto& [name, entity] : graph_.entities_) {
    for (const std::string& label : entity.labels) {
      const auto [owner, isFirst] = owners.emplace(label, name);
      if (isFirst || graph_.entities_.at(owner->second).mobility == entity.mobility) continue;
      entityNodes_.at(name).fail(labelConflict(label, owner->second, name));
    }
  }
}

void KnowledgeReader::readRelations() { graph_.relations_ = namesIn(root_.child("relations")); }

void KnowledgeReader::readFacts() {
  for (const ConfigNode& node : itemsOf(root_.child("facts"))) {
    const Fact fact = readFact(node);
    if (fact.relation == kCanBeMovedBy) checkMove(fact, node);
    for (const std::string& head : graph_.members_.at(fact.head)) {
      for (const std::string& tail : graph_.members_.at(fact.tail)) {
        graph_.expanded_[{head, fact.relation, tail}] = fact.bond;
      }
    }
    graph_.facts_.push_back(fact);
  }
}

Fact KnowledgeReader::readFact(const ConfigNode& node) const {
  const auto items = itemsOf(node);
  if (items.size() < 3 || items.size() > 4) {
    node.fail("a fact has three parts, and strength and reach if wanted: [head, relation, tail, {strength: 0.5}]");
  }
  const Names parts = {textOf(items[0]), textOf(items[1]), textOf(items[2])};
  requireKnown(parts[0], node);
  requireKnown(parts[2], node);
  const Names& relations = graph_.relations_;
  if (std::find(relations.begin(), relations.end(), parts[1]) == relations.end()) {
    const std::string nearest = core::nearestName(parts[1], relations);
    node.fail("unknown relation '" + parts[1] + "'" +
              (nearest.empty() ? "; list it under 'relations'" : "; did you mean '" + nearest + "'?"));
  }
  Fact fact{parts[0], parts[1], parts[2], {}};
  if (items.size() == 4) core::readOptions(items[3], fact.bond);
  return fact;
}

void KnowledgeReader::checkMove(const Fact& fact, const ConfigNode& node) const {
  for (const std::string& head : graph_.members_.at(fact.head)) {
    if (graph_.mobility(head) == Mobility::Static) {
      node.fail("'" + head + "' is static and cannot be moved; take the fact away or put it into 'movable'");
    }
  }
  for (const std::string& tail : graph_.members_.at(fact.tail)) {
    if (graph_.mobility(tail) != Mobility::Moving) {
      node.fail("'" + tail + "' is not in the set 'moving', so nothing can be moved by it");
    }
  }
}

void KnowledgeReader::claimName(const std::string& name, const ConfigNode& where) const {
  if (graph_.entities_.count(name) + setNodes_.count(name) > 0) {
    where.fail("'" + name + "' is the name of an entity or set already");
  }
}

void KnowledgeReader::requireKnown(const std::string& name, const ConfigNode& where) const {
  if (graph_.entities_.count(name) + setNodes_.count(name) > 0) return;
  Names known;
  for (const auto& [entity, node] : entityNodes_) known.push_back(entity);
  for (const auto& [set, node] : setNodes_) known.push_back(set);
  where.fail("unknown entity or set '" + name + "'; did you mean '" + core::nearestName(name, known) + "'?");
}

}  // namespace wardslam::knowledge
