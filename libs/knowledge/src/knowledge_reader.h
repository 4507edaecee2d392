#pragma once

#include <map>
#include <string>
#include <vector>

#include "wardslam/knowledge/knowledge_graph.h"

namespace wardslam::knowledge {

/// Reads a KnowledgeGraph from YAML and checks that it does not contradict itself.
class KnowledgeReader {
 public:
  explicit KnowledgeReader(core::ConfigNode root) : root_(std::move(root)) {}

  /// Throws core::InputError. Call once.
  [[nodiscard]] KnowledgeGraph read();

 private:
  using Names = std::vector<std::string>;

  void readEntities();
  void readSets();
  const std::set<std::string>& expand(const std::string& name, Names& path);
  void assignMobility();
  void checkLabels() const;
  void readRelations();
  void readFacts();
  [[nodiscard]] Fact readFact(const core::ConfigNode& node) const;
  void checkMove(const Fact& fact, const core::ConfigNode& node) const;

  void claimName(const std::string& name, const core::ConfigNode& where) const;
  void requireKnown(const std::string& name, const core::ConfigNode& where) const;

  core::ConfigNode root_;
  KnowledgeGraph graph_;
  std::map<std::string, core::ConfigNode> entityNodes_;  ///< The key of each entity: where to point at in errors.
  std::map<std::string, core::ConfigNode> setNodes_;     ///< The list of each set.
};

}  // namespace wardslam::knowledge
