#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "wardslam/core/options.h"

namespace wardslam::knowledge {

/// The one of the sets `moving`, `movable`, `static` an entity belongs to: P_moving, P_movable and the rest (P2).
enum class Mobility : std::uint8_t { Moving, Movable, Static };

/// Of the relations, the one that says who can move what.
inline constexpr const char* kCanBeMovedBy = "can_be_moved_by";

/// How much a relation counts, and from how near.
struct Bond {
  double strength = 0.5;  ///< Probability, 0..1, that it is at work between two that are within reach.
  double reach_m = 0.3;   ///< Gap between their surfaces up to which it can be.

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("strength", self.strength, {0.0, 1.0}, "", "how likely it is at work between two that are within reach");
    visit("reach", self.reach_m, {0.0, 100.0}, "m", "gap between their surfaces up to which it can be");
  }
};

/// (h, r, t) of F.
struct Fact {
  std::string head;
  std::string relation;
  std::string tail;
  Bond bond;
};

/// What is known about a scene before the run: G = {E, R, F}, entities, relations and facts (P2).
///
///     entities:                               # name: the labels a segmenter may give it (none is fine)
///       nurse: [person]
///       visitor: [person]                     # one label may stand for several entities
///       cup: [cup, wine glass]
///       bed: [bed]
///     sets:                                   # of entities and of other sets
///       people: [nurse, visitor]
///       moving: [people]                      # every entity is in exactly one of moving, movable, static
///       movable: [cup]
///       static: [bed]
///     relations: [can_be_moved_by]
///     facts:                                  # [head, relation, tail]; a set stands for each of its members
///       - [cup, can_be_moved_by, people]
///       - [cup, can_be_moved_by, nurse, {strength: 0.8, reach: 0.4}]    # overrules the one before for nurses
class KnowledgeGraph {
 public:
  /// Throw core::InputError naming file and line or key: unknown entity, set or relation; an entity in none or two of
  /// moving, movable, static; sets in a circle; a name used twice; a label of entities that differ in mobility; a
  /// can_be_moved_by fact about a static head or with a tail that does not move by itself; a strength outside 0..1.
  [[nodiscard]] static KnowledgeGraph fromFile(const std::filesystem::path& file);
  [[nodiscard]] static KnowledgeGraph fromConfig(const core::ConfigNode& root);

  [[nodiscard]] std::vector<std::string> entities() const;
  [[nodiscard]] std::vector<std::string> sets() const;
  [[nodiscard]] const std::vector<std::string>& relations() const { return relations_; }
  [[nodiscard]] const std::vector<Fact>& facts() const { return facts_; }  ///< As written, sets not expanded.

  // The queries throw core::InputError, naming the nearest known name, for an entity or set that does not exist.

  [[nodiscard]] Mobility mobility(const std::string& entity) const;
  [[nodiscard]] bool isMoving(const std::string& entity) const { return mobility(entity) == Mobility::Moving; }
  [[nodiscard]] bool isMovable(const std::string& entity) const { return mobility(entity) == Mobility::Movable; }
  [[nodiscard]] bool canBeMovedBy(const std::string& entity, const std::string& byEntity) const;

  /// Whether (head, relation, tail) is a fact about these two entities, be it through a set.
  [[nodiscard]] bool holds(const std::string& head, const std::string& relation, const std::string& tail) const;

  /// Strength and reach of a fact about these two entities; of several that hold, the last written. Strength 0 where
  /// none holds.
  [[nodiscard]] Bond bond(const std::string& head, const std::string& relation, const std::string& tail) const;

  /// All facts with this entity as head or tail, sets expanded to their members.
  [[nodiscard]] std::vector<Fact> factsAbout(const std::string& entity) const;

  /// What a set was written to contain: entities and other sets.
  [[nodiscard]] const std::vector<std::string>& contents(const std::string& set) const;

  /// The entities of a set, sets in it expanded; of an entity: itself.
  [[nodiscard]] const std::set<std::string>& members(const std::string& setOrEntity) const;

  [[nodiscard]] const std::vector<std::string>& labels(const std::string& entity) const;

  /// The entities a label may stand for, all of the same mobility; empty for a label nobody knows.
  [[nodiscard]] std::vector<std::string> entitiesOf(const std::string& label) const;

 private:
  friend class KnowledgeReader;
  KnowledgeGraph() = default;

  struct Entity {
    std::vector<std::string> labels;
    Mobility mobility = Mobility::Static;
  };

  [[nodiscard]] const Entity& at(const std::string& entity) const;

  std::map<std::string, Entity> entities_;
  std::map<std::string, std::vector<std::string>> contents_;  ///< Of each set, as written.
  std::map<std::string, std::set<std::string>> members_;      ///< Of each set, and of each entity: itself.
  std::vector<std::string> relations_;
  std::vector<Fact> facts_;
  std::map<std::tuple<std::string, std::string, std::string>, Bond> expanded_;  ///< The facts between entities.
};

}  // namespace wardslam::knowledge
