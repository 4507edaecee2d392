#include "object_table.h"

#include "object_shape.h"
#include "wardslam/mapping/semantic_color.h"

namespace wardslam::mapping {
namespace {

constexpr int kFewestViews = 2;

void describe(const ObjectRecord& record, MapObject& row) {
  row.classId = record.classId();
  row.probability = record.probability();
  row.color_rgb = semanticColor(row.classId);
  row.firstSeen_s = record.firstSeen_s;
  row.lastSeen_s = record.lastSeen_s;
  row.views = record.views;
  row.state = record.state;
}

void place(const std::vector<Eigen::Vector3f>& points_m, MapObject& row) {
  const ObjectShape shape = shapeOf(points_m, kPartGap_m);
  row.centroid_m = shape.centroid_m;
  row.box_m = shape.box_m;
  row.orientedBox = shape.orientedBox;
}

}  // namespace

std::set<ObjectId> ObjectTable::update(const std::set<ObjectId>& touched, const ObjectDatabase& database,
                                       const SemanticCloud& cloud) {
  std::set<ObjectId> changed;
  const auto points = cloud.pointsOf(touched);
  for (const ObjectId id : touched) {
    const auto record = database.objects().find(id);
    const bool isKnown = rows_.count(id) > 0;
    const bool isGone = record != database.objects().end() && record->second.state == ObjectState::Gone;
    const bool isThere = record != database.objects().end() && isEstablished(record->second) &&
                         (isGone ? isKnown : points.at(id).size() >= static_cast<std::size_t>(options_.min_points));
    if (isThere) {
      MapObject& row = rows_[id];
      row.id = id;
      describe(record->second, row);
      if (!isGone) place(points.at(id), row);  // what is gone keeps the place it had
    } else {
      rows_.erase(id);
    }
    if (isKnown || isThere) changed.insert(id);
  }
  return changed;
}

std::set<ObjectId> ObjectTable::hint(const std::map<ObjectId, MaybeSame>& hints) {
  std::set<ObjectId> changed;
  for (auto& [id, row] : rows_) {
    const auto hint = hints.find(id);
    const MaybeSame is = hint == hints.end() ? MaybeSame{} : hint->second;
    const MaybeSame was = row.maybeSameAs.value_or(MaybeSame{});
    if (is.id == was.id && is.probability == was.probability) continue;
    row.maybeSameAs = is.id == 0 ? std::nullopt : std::optional(is);
    changed.insert(id);
  }
  return changed;
}

bool ObjectTable::isEstablished(const ObjectRecord& record) const {
  return record.views >= kFewestViews && record.evidence() >= options_.min_evidence && !record.isMissing() &&
         record.views >= options_.min_seen_fraction * std::max(record.expected, record.views);
}

}  // namespace wardslam::mapping
