#include "wardslam/query/map_difference.h"

#include <algorithm>
#include <set>

namespace wardslam::query {
namespace {

/// Every pair of one class that could be one and the same thing, nearest first.
std::vector<MapDifference::Moved> candidatePairs(const mapping::SemanticMap& before,
                                                 const mapping::SemanticMap& after) {
  std::multimap<core::ClassId, const mapping::MapObject*> afterByClass;
  for (const auto& [id, object] : after.objects) {
    if (object.state != mapping::ObjectState::Gone) afterByClass.emplace(object.classId, &object);
  }
  std::vector<MapDifference::Moved> pairs;
  for (const auto& [id, object] : before.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    const auto [first, last] = afterByClass.equal_range(object.classId);
    for (auto other = first; other != last; ++other) {
      pairs.push_back({&object, other->second, (object.centroid_m - other->second->centroid_m).norm()});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.distance_m < b.distance_m; });
  return pairs;
}

std::vector<const mapping::MapObject*> notIn(const std::set<const mapping::MapObject*>& paired,
                                             const mapping::SemanticMap& map) {
  std::vector<const mapping::MapObject*> rest;
  for (const auto& [id, object] : map.objects) {
    if (object.state != mapping::ObjectState::Gone && paired.count(&object) == 0) rest.push_back(&object);
  }
  return rest;
}

Eigen::AlignedBox3d around(const mapping::OrientedBox& box) {
  Eigen::AlignedBox3d around_m;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d side((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                               (corner & 4) != 0 ? 0.5 : -0.5);
    around_m.extend(box.T_map_box * side.cwiseProduct(box.size_m));
  }
  return around_m;
}

}  // namespace

void moveObject(mapping::MapObject& object, const Eigen::Isometry3d& T_other_map) {
  object.centroid_m = T_other_map * object.centroid_m;
  object.orientedBox.T_map_box = T_other_map * object.orientedBox.T_map_box;
  object.box_m = around(object.orientedBox);
}

MapDifference difference(const mapping::SemanticMap& before, const mapping::SemanticMap& after, double tolerance_m) {
  MapDifference result;
  std::set<const mapping::MapObject*> paired;
  for (const auto& pair : candidatePairs(before, after)) {
    if (paired.count(pair.before) != 0 || paired.count(pair.after) != 0) continue;
    paired.insert({pair.before, pair.after});
    if (pair.distance_m < tolerance_m) {
      ++result.unchanged;
    } else {
      result.moved.push_back(pair);
    }
  }
  result.gone = notIn(paired, before);
  result.added = notIn(paired, after);
  return result;
}

}  // namespace wardslam::query
