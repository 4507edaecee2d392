#include "same_things.h"

#include <algorithm>
#include <iterator>

#include "object_shape.h"

namespace wardslam::mapping {
namespace {

/// Two objects of one class are one when their boxes share so much of the smaller.
constexpr double kSameBox = 0.5;

/// A thing that moved is found again by its class and by its longest side, which agree within this factor.
constexpr double kSameSize = 2.0;

/// A thing last seen in somebody's hands is looked for elsewhere after so long.
constexpr double kCarrying_s = 1.0;

double sharedOfSmaller(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double margin_m) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(margin_m);
  const Eigen::AlignedBox3d first(a.min() - margin, a.max() + margin);
  const Eigen::AlignedBox3d second(b.min() - margin, b.max() + margin);
  const Eigen::AlignedBox3d shared = first.intersection(second);
  return shared.isEmpty() ? 0.0 : shared.volume() / std::min(first.volume(), second.volume());
}

bool coverOnePlace(const MapObject& a, const MapObject& b, double margin_m) {
  if (a.classId != b.classId || a.state == ObjectState::Gone || b.state == ObjectState::Gone) return false;
  return sharedOfSmaller(a.box_m, b.box_m, margin_m) > kSameBox;
}

/// Whether it need not be any more where it was seen last, when the other was seen first at `since_s`.
bool isLost(const ObjectRecord& record, double since_s) {
  const bool isCarriedOn = record.viewsToRest > 0 && since_s > record.lastSeen_s + kCarrying_s;
  return record.state == ObjectState::Gone || record.isMissing() || isCarriedOn;
}

/// The longest side of an object, be it gone or not yet told to anybody; 0 where nothing is known of it.
double lengthOf(ObjectId id, const ObjectTable& table, const SemanticCloud& cloud) {
  const auto row = table.rows().find(id);
  if (row != table.rows().end()) return row->second.box_m.sizes().maxCoeff();
  const auto points = cloud.pointsOf({id}).at(id);
  return points.empty() ? 0.0 : shapeOf(points, kPartGap_m).box_m.sizes().maxCoeff();
}

}  // namespace

std::vector<std::pair<ObjectId, ObjectId>> sameBoxes(const ObjectTable& table, const ObjectDatabase& database,
                                                     double margin_m) {
  std::vector<std::pair<ObjectId, ObjectId>> same;
  for (auto older = table.rows().begin(); older != table.rows().end(); ++older) {
    for (auto newer = std::next(older); newer != table.rows().end(); ++newer) {
      if (!coverOnePlace(older->second, newer->second, margin_m)) continue;
      if (!database.areApart(older->first, newer->first)) same.emplace_back(newer->first, older->first);
    }
  }
  return same;
}

std::vector<ObjectId> earlierPlacesOf(const MapObject& found, const ObjectTable& table, const ObjectDatabase& database,
                                      const SemanticCloud& cloud) {
  const double foundLength_m = found.box_m.sizes().maxCoeff();
  std::vector<ObjectId> earlier;
  for (const auto& [id, record] : database.objects()) {
    if (id == found.id || record.classId() != found.classId || !isLost(record, found.firstSeen_s)) continue;
    if (found.firstSeen_s <= record.lastSeen_s) continue;  // were seen at the same time
    const double length_m = lengthOf(id, table, cloud);
    if (foundLength_m < kSameSize * length_m && length_m < kSameSize * foundLength_m) earlier.push_back(id);
  }
  return earlier;
}

}  // namespace wardslam::mapping
