#pragma once

#include <map>
#include <set>

#include "object_database.h"
#include "semantic_cloud.h"
#include "wardslam/mapping/map_object.h"

namespace wardslam::mapping {

/// The objects of a map as they are told to others: those seen often enough, with their boxes.
class ObjectTable {
 public:
  explicit ObjectTable(const ObjectOptions& options) : options_(options) {}

  /// Describes anew what was touched since. Returns the objects whose rows changed, came or went.
  std::set<ObjectId> update(const std::set<ObjectId>& touched, const ObjectDatabase& database,
                            const SemanticCloud& cloud);

  /// Which objects may be others that were lost; all other rows lose their hints. Returns those whose hints changed.
  std::set<ObjectId> hint(const std::map<ObjectId, MaybeSame>& hints);

  /// A row of an earlier map.
  void restore(const MapObject& row) { rows_[row.id] = row; }

  [[nodiscard]] const std::map<ObjectId, MapObject>& rows() const { return rows_; }

 private:
  [[nodiscard]] bool isEstablished(const ObjectRecord& record) const;

  ObjectOptions options_;
  std::map<ObjectId, MapObject> rows_;
};

}  // namespace wardslam::mapping
