#include "same_things.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace wardslam::mapping {
namespace {

/// Two objects of one class are one when their boxes share so much of the smaller.
constexpr double kSameBox = 0.5;

/// So much is enough where an image showed both as one.
constexpr double kSameBoxSeenAsOne = 0.3;

/// So few images show no more than one side of a thing.
constexpr int kFewViews = 3;

/// A thing that moved is found again by its class and by its longest side, which agree within this factor.
constexpr double kSameSize = 2.0;

/// Who pushes a thing that stays near does not need long, nor far; then nobody need have seen the new place empty.
constexpr double kPutDown_s = 30.0;
constexpr double kPutDown_m = 3.0;

/// How probable a pair is for its distance falls off from here; things are mostly found near where they stood.
constexpr double kNear_m = 3.0;

/// The weight of "a thing nobody knew before" beside that of a pair at no distance, and what a pair that nobody
/// witnessed counts.
constexpr double kUnknown = 0.005;
constexpr double kUnwitnessed = 0.3;

/// The middles of boxes that were seen from other sides differ by so much.
constexpr double kSlack_m = 1.0;

double sharedOfSmaller(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double margin_m) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(margin_m);
  const Eigen::AlignedBox3d first(a.min() - margin, a.max() + margin);
  const Eigen::AlignedBox3d second(b.min() - margin, b.max() + margin);
  const Eigen::AlignedBox3d shared = first.intersection(second);
  return shared.isEmpty() ? 0.0 : shared.volume() / std::min(first.volume(), second.volume());
}

/// What no image need be asked for.
bool mayBeOne(const MapObject& a, const MapObject& b, double margin_m) {
  if (a.classId != b.classId || a.state == ObjectState::Gone || b.state == ObjectState::Gone) return false;
  return sharedOfSmaller(a.box_m, b.box_m, margin_m) > 0.0;
}

bool coverOnePlace(const MapObject& a, const MapObject& b, bool areSeenAsOne, double margin_m) {
  const double shared = sharedOfSmaller(a.box_m, b.box_m, margin_m);
  const bool isOneSide = std::min(a.views, b.views) <= kFewViews;
  return shared > (isOneSide ? 0.0 : areSeenAsOne ? kSameBoxSeenAsOne : kSameBox);
}

bool isInHands(const ObjectRecord& record) { return record.viewsToRest > 0; }

/// When it was known not to be where it was seen last.
double lossKnown_s(const ObjectRecord& record) {
  return record.state == ObjectState::Gone ? record.gone_s : record.handled_s;
}

/// What was known before this run is nothing that this run lost, whatever the clocks say.
bool isTooOld(const ObjectRecord& lost, const ObjectRecord& found) {
  return lost.thisRun.isLost && !found.thisRun.isNew;
}

/// How well the two fit together; 0 where they cannot be one thing.
double fit(const MapObject& lost, const MapObject& found, const ObjectOptions& options) {
  const double time_s = found.firstSeen_s - lost.lastSeen_s;
  const double distance_m = (found.centroid_m - lost.centroid_m).norm();
  if (time_s <= 0 || distance_m > options.push_speed_mps * time_s + kSlack_m) return 0.0;
  const double lengths[] = {lost.box_m.sizes().maxCoeff(), found.box_m.sizes().maxCoeff()};
  const double ratio = std::min(lengths[0], lengths[1]) / std::max(lengths[0], lengths[1]);
  if (!(ratio * kSameSize > 1.0)) return 0.0;
  return ratio / (1.0 + distance_m * distance_m / (kNear_m * kNear_m));
}

bool isWitnessed(const MapObject& lost, const ObjectRecord& lostRecord, const MapObject& found,
                 const ObjectRecord& foundRecord) {
  if (found.firstSeen_s <= lossKnown_s(lostRecord)) return false;
  const bool isPutDownNearby = isInHands(lostRecord) && found.firstSeen_s - lostRecord.handled_s < kPutDown_s &&
                               (found.centroid_m - lost.centroid_m).norm() < kPutDown_m;
  return foundRecord.placeWasEmpty || isPutDownNearby;
}

}  // namespace

std::vector<std::pair<ObjectId, ObjectId>> sameBoxes(const std::set<ObjectId>& objects, const ObjectTable& table,
                                                     const ObjectDatabase& database, double margin_m) {
  std::set<std::pair<ObjectId, ObjectId>> pairs;  // the older first
  for (const ObjectId id : objects) {
    const auto row = table.rows().find(id);
    if (row == table.rows().end()) continue;
    for (const auto& [other, otherRow] : table.rows()) {
      if (other != id && mayBeOne(row->second, otherRow, margin_m)) pairs.insert(std::minmax(id, other));
    }
  }
  std::vector<std::pair<ObjectId, ObjectId>> same;
  for (const auto& [older, newer] : pairs) {
    const bool areSeenAsOne = database.areSeenAsOne(older, newer);
    if (!coverOnePlace(table.rows().at(older), table.rows().at(newer), areSeenAsOne, margin_m)) continue;
    if (!database.areApart(older, newer)) same.emplace_back(newer, older);
  }
  return same;
}

std::vector<std::pair<ObjectId, ObjectId>> sameBoxes(const ObjectTable& table, const ObjectDatabase& database,
                                                     double margin_m) {
  std::set<ObjectId> all;
  for (const auto& [id, row] : table.rows()) all.insert(id);
  return sameBoxes(all, table, database, margin_m);
}

std::vector<Reappearance> reappearances(const ObjectTable& table, const ObjectDatabase& database,
                                        const knowledge::ClassSet& movable, const ObjectOptions& options) {
  std::vector<Reappearance> pairs;
  std::map<ObjectId, double> sums;  // over the pairs each record is in
  for (const auto& [lostId, lost] : table.rows()) {
    const auto lostRecord = database.objects().find(lostId);
    if (!movable[lost.classId] || lostRecord == database.objects().end()) continue;
    if (lost.state != ObjectState::Gone && !isInHands(lostRecord->second)) continue;
    for (const auto& [foundId, found] : table.rows()) {
      const auto foundRecord = database.objects().find(foundId);
      if (foundId == lostId || found.classId != lost.classId || found.state == ObjectState::Gone) continue;
      if (foundRecord == database.objects().end() || isTooOld(lostRecord->second, foundRecord->second)) continue;
      double weight = fit(lost, found, options);
      if (weight <= 0) continue;
      const bool witnessed = isWitnessed(lost, lostRecord->second, found, foundRecord->second);
      if (!witnessed) weight *= kUnwitnessed;
      pairs.push_back({lostId, foundId, weight, witnessed});
      sums[lostId] += weight;
      sums[foundId] += weight;
    }
  }
  for (Reappearance& pair : pairs) {
    const double all = kUnknown + sums[pair.lost] + sums[pair.found] - pair.probability;
    pair.probability *= (pair.isWitnessed ? 1.0 : kUnwitnessed) / all;
  }
  return pairs;
}

}  // namespace wardslam::mapping
