#pragma once

#include <utility>
#include <vector>

#include "object_database.h"
#include "object_table.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::mapping {

/// Objects that are one thing because they are of one class and their boxes share most of the smaller, or a third where
/// an image showed both as one, or touch where only a few images show one of them, as one side of the other; unless
/// images told them apart: {from, into}, the older one last. Boxes count as larger by `margin_m` on each side, for
/// pictures and screens are flat.
[[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>> sameBoxes(const ObjectTable& table,
                                                                   const ObjectDatabase& database, double margin_m);

/// The same, of pairs with one of these at least.
[[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>> sameBoxes(const std::set<ObjectId>& objects,
                                                                   const ObjectTable& table,
                                                                   const ObjectDatabase& database, double margin_m);

/// A record of what was lost, and one that may be the same thing at the place it was moved to.
struct Reappearance {
  ObjectId lost = 0;
  ObjectId found = 0;
  double probability = 0.0;  ///< Among all that was lost and found, and things nobody knew before.
  bool isWitnessed = false;  ///< The loss was known and the new place seen empty before it stood there.
};

/// Every pair that may be one thing: of one class that somebody can move, about as long, never seen at the same time,
/// and no farther apart than it can be pushed in the time between. Nearer pairs are more probable, and each record
/// shares its probability among all pairs it is in, so no record is in two that are more probable than 0.5.
[[nodiscard]] std::vector<Reappearance> reappearances(const ObjectTable& table, const ObjectDatabase& database,
                                                      const knowledge::ClassSet& movable, const ObjectOptions& options);

}  // namespace wardslam::mapping
