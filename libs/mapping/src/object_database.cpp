#include "object_database.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace wardslam::mapping {
namespace {

/// How often it was seen of the times it should have been, by Laplace's rule of succession.
double foundShare(const ObjectRecord& record) {
  return (record.views + 1.0) / (std::max(record.expected, record.views) + 2.0);
}

constexpr int kConvincing = 2;         // views that must show two objects as one
constexpr double kCovered = 0.5;       // of an object's points in sight, for a mask to cover it
constexpr std::size_t kFewPoints = 8;  // too few points in sight to judge by
constexpr double kGoneRatio = 2.0;     // an object is gone when it lost so many times what is left

constexpr double kHandling_s = 2.0;  // so long and so near a thing may be gone on with out of the picture
constexpr float kHandling_m = 1.0F;
constexpr int kViewsToRest = 5;

std::size_t countOf(const std::map<ObjectId, std::size_t>& counts, ObjectId id) {
  const auto entry = counts.find(id);
  return entry == counts.end() ? 0 : entry->second;
}

std::pair<ObjectId, ObjectId> ordered(ObjectId a, ObjectId b) { return {std::min(a, b), std::max(a, b)}; }

double ratio(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

ObjectRecord ObjectRecord::from(const MapObject& object, double least_evidence) {
  ObjectRecord record;
  record.views = record.expected = object.views;
  record.firstSeen_s = object.firstSeen_s;
  record.lastSeen_s = object.lastSeen_s;
  record.state = object.state;
  record.votes[object.classId] = std::max(least_evidence, object.probability / foundShare(record) * object.views);
  record.lastPlace_m = object.centroid_m.cast<float>();
  if (object.state == ObjectState::Gone) record.gone_s = object.lastSeen_s;
  return record;
}

core::ClassId ObjectRecord::classId() const {
  const auto best =
      std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return best == votes.end() ? core::ClassId{0} : best->first;
}

double ObjectRecord::evidence() const {
  return std::accumulate(votes.begin(), votes.end(), 0.0,
                         [](double sum, const auto& vote) { return sum + vote.second; });
}

double ObjectRecord::probability() const {
  const double all = evidence();
  if (views == 0 || all <= 0) return 0.0;
  const double share = votes.at(classId()) / all;
  const double confidence = all / views;
  return std::min(1.0, share * confidence * foundShare(*this));
}

std::vector<ObjectDatabase::Match> ObjectDatabase::candidates(const std::vector<Evidence>& detections,
                                                              const std::map<ObjectId, std::size_t>& inSight) const {
  std::vector<Match> matches;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const Evidence& detection = detections[i];
    for (const auto& [id, shared] : detection.onObjects) {
      const std::size_t visible = std::max(countOf(inSight, id), shared);
      const bool isSameClass = objects_.at(id).classId() == detection.classId;
      const double overlap =
          ratio(shared, isSameClass ? std::min(detection.size, visible) : std::max(detection.size, visible));
      if (overlap < (isSameClass ? options_.min_overlap : options_.min_overlap_across_classes)) continue;
      matches.push_back({overlap * static_cast<double>(shared), i, id});
    }
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.overlap > b.overlap; });
  return matches;
}

std::vector<ObjectId> ObjectDatabase::observe(const std::vector<Evidence>& detections,
                                              const std::map<ObjectId, std::size_t>& inSight, double stamp_s,
                                              ObjectId& nextId) {
  std::vector<ObjectId> assigned(detections.size(), 0);
  for (const Match& match : candidates(detections, inSight)) {
    if (assigned[match.detection] == 0) assigned[match.detection] = match.object;
  }
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (assigned[i] == 0) {
      assigned[i] = nextId++;
      objects_[assigned[i]].firstSeen_s = stamp_s;
      objects_[assigned[i]].thisRun.isNew = true;
      objects_[assigned[i]].placeWasEmpty = detections[i].placeWasEmpty;
    }
    objects_.at(assigned[i]).votes[detections[i].classId] += detections[i].confidence;
    objects_.at(assigned[i]).lastPlace_m = detections[i].place_m;
  }
  const std::set<ObjectId> seen(assigned.begin(), assigned.end());
  for (const ObjectId id : seen) {
    ObjectRecord& object = objects_.at(id);
    ++object.views;
    object.lastSeen_s = stamp_s;
    object.thisRun.isSeen = true;
    object.erased = 0;
    object.missed = 0;
    object.viewsToRest = std::max(0, object.viewsToRest - 1);
    if (object.state == ObjectState::Gone) object.state = ObjectState::Static;
  }
  for (const auto& [id, points] : inSight) {
    const auto object = objects_.find(id);
    if (object == objects_.end()) continue;
    const bool isSeen = seen.count(id) > 0;
    if (isSeen || points >= kFewPoints) ++object->second.expected;
    if (!isSeen && points >= kFewPoints) ++object->second.missed;
  }
  markHandled(stamp_s);
  relate(detections, assigned, inSight);
  mergeRelated();
  return assigned;
}

void ObjectDatabase::noteHandled(core::ClassId classId, const Eigen::Vector3f& place_m, double stamp_s) {
  handlings_.push_back({classId, place_m, stamp_s});
}

void ObjectDatabase::markHandled(double stamp_s) {
  const auto isOld = [&](const Handling& h) { return stamp_s - h.stamp_s > kHandling_s; };
  handlings_.erase(std::remove_if(handlings_.begin(), handlings_.end(), isOld), handlings_.end());
  for (auto& [id, object] : objects_) {
    if (!object.thisRun.isSeen || stamp_s - object.lastSeen_s > kHandling_s) continue;
    for (const Handling& handling : handlings_) {
      const bool isNews = !object.thisRun.isLost || handling.stamp_s > object.handled_s;
      const bool isIt = isNews && handling.classId == object.classId() &&
                        (handling.place_m - object.lastPlace_m).norm() < kHandling_m;
      if (!isIt) continue;
      object.thisRun.isLost = true;
      object.handled_s = handling.stamp_s;
      object.viewsToRest = kViewsToRest;
    }
  }
}

void ObjectDatabase::relate(const std::vector<Evidence>& detections, const std::vector<ObjectId>& assigned,
                            const std::map<ObjectId, std::size_t>& inSight) {
  const std::set<ObjectId> seen(assigned.begin(), assigned.end());
  for (auto a = seen.begin(); a != seen.end(); ++a) {
    for (auto b = std::next(a); b != seen.end(); ++b) {
      if (objects_.at(*a).classId() == objects_.at(*b).classId()) ++relations_[{*a, *b}].apart;
    }
  }
  for (const Evidence& detection : detections) {
    std::vector<ObjectId> covered;
    for (const auto& [id, shared] : detection.underMask) {
      const std::size_t visible = countOf(inSight, id);
      if (objects_.at(id).classId() != detection.classId || visible < kFewPoints) continue;
      if (ratio(shared, visible) >= kCovered) covered.push_back(id);
    }
    for (std::size_t i = 0; i < covered.size(); ++i) {
      for (std::size_t j = i + 1; j < covered.size(); ++j) {
        const auto pair = ordered(covered[i], covered[j]);
        ++relations_[pair].together;
        moreTogether_.insert(pair);
      }
    }
  }
}

void ObjectDatabase::mergeRelated() {
  std::vector<std::pair<ObjectId, ObjectId>> same;
  for (const auto& pair : std::exchange(moreTogether_, {})) {
    const auto relation = relations_.find(pair);
    if (relation == relations_.end()) continue;
    const auto& [together, apart] = relation->second;
    if (together >= kConvincing && together > apart) same.push_back(pair);
  }
  for (const auto& [into, from] : same) merge(from, into);
}

bool ObjectDatabase::areApart(ObjectId a, ObjectId b) const {
  const auto relation = relations_.find(ordered(a, b));
  return relation != relations_.end() && relation->second.apart > relation->second.together;
}

bool ObjectDatabase::areSeenAsOne(ObjectId a, ObjectId b) const {
  const auto relation = relations_.find(ordered(a, b));
  return relation != relations_.end() && relation->second.together > relation->second.apart;
}

void ObjectDatabase::merge(ObjectId from, ObjectId into) {
  const auto gone = objects_.find(from);
  const auto kept = objects_.find(into);
  if (gone == objects_.end() || kept == objects_.end() || from == into) return;
  ObjectRecord& object = kept->second;
  for (const auto& [c, confidence] : gone->second.votes) object.votes[c] += confidence;
  object.views += gone->second.views;
  object.expected += gone->second.expected;
  if (gone->second.firstSeen_s < object.firstSeen_s) object.placeWasEmpty = gone->second.placeWasEmpty;
  object.firstSeen_s = std::min(object.firstSeen_s, gone->second.firstSeen_s);
  object.lastSeen_s = std::max(object.lastSeen_s, gone->second.lastSeen_s);
  object.missed = std::min(object.missed, gone->second.missed);
  object.thisRun.isNew = object.thisRun.isNew && gone->second.thisRun.isNew;
  object.thisRun.isSeen = object.thisRun.isSeen || gone->second.thisRun.isSeen;
  objects_.erase(gone);
  std::map<std::pair<ObjectId, ObjectId>, PairMemory> relations;
  for (const auto& [pair, relation] : relations_) {
    const ObjectId a = pair.first == from ? into : pair.first;
    const ObjectId b = pair.second == from ? into : pair.second;
    if (a == b) continue;
    if (a == into || b == into) moreTogether_.insert(ordered(a, b));
    relations[ordered(a, b)].together += relation.together;
    relations[ordered(a, b)].apart += relation.apart;
  }
  relations_ = std::move(relations);
  merges_.emplace_back(from, into);
}

std::vector<ObjectId> ObjectDatabase::erase(const std::map<ObjectId, std::size_t>& points,
                                            const std::map<ObjectId, std::size_t>& left, double stamp_s) {
  std::vector<ObjectId> gone;
  for (const auto& [id, count] : points) {
    const auto object = objects_.find(id);
    if (object == objects_.end() || object->second.state == ObjectState::Gone) continue;
    object->second.erased += count;
    if (static_cast<double>(object->second.erased) < kGoneRatio * static_cast<double>(countOf(left, id))) continue;
    object->second.state = ObjectState::Gone;
    object->second.thisRun.isLost = true;
    object->second.gone_s = stamp_s;
    gone.push_back(id);
  }
  return gone;
}

void ObjectDatabase::lose(ObjectId id, double lastSeen_s) {
  ObjectRecord& object = objects_.at(id);
  if (object.state == ObjectState::Gone) return;
  object.state = ObjectState::Gone;
  object.gone_s = lastSeen_s;
}

void ObjectDatabase::reunite(ObjectId lost, ObjectId found) {
  const int viewsToRest = objects_.at(found).viewsToRest;
  const Eigen::Vector3f place_m = objects_.at(found).lastPlace_m;
  merge(found, lost);
  ObjectRecord& object = objects_.at(lost);
  object.lastPlace_m = place_m;
  object.state = ObjectState::Moved;
  object.erased = 0;
  object.missed = 0;
  object.viewsToRest = viewsToRest;
}

void ObjectDatabase::absorb(ObjectDatabase&& other) {
  objects_.merge(other.objects_);
  relations_.merge(other.relations_);
  moreTogether_.merge(other.moreTogether_);
}

}  // namespace wardslam::mapping
