#include "recognition.h"

#include "seen_through.h"

namespace wardslam::mapping {
namespace {

std::vector<Eigen::Vector3f> placesOf(const Detection& detection, const std::vector<Sample>& samples) {
  std::vector<Eigen::Vector3f> places_m;
  for (const std::size_t i : detection.samples) places_m.push_back(samples[i].p_map_m);
  return places_m;
}

bool isMostlyNew(const Evidence& evidence) {
  std::size_t known = 0;
  for (const auto& [id, count] : evidence.onObjects) known += count;
  return 2 * known < evidence.size;
}

}  // namespace

std::vector<Evidence> evidenceOf(const Recognition& seen, const SemanticCloud& cloud,
                                 const knowledge::ClassSet& movable, double range_m) {
  const auto objectAt = [&](std::size_t i) { return seen.points[i] ? cloud.at(*seen.points[i]).object : 0; };
  std::vector<Evidence> evidence;
  for (const Detection& detection : seen.detections) {
    Evidence& e = evidence.emplace_back();
    e.classId = detection.classId;
    e.confidence = detection.confidence;
    e.size = detection.samples.size();
    e.place_m = detection.centroid_m;
    for (const std::size_t i : detection.samples) {
      if (const ObjectId id = objectAt(i)) ++e.onObjects[id];
    }
    e.underMask = e.onObjects;
    for (const std::size_t i : detection.doubtful) {
      if (const ObjectId id = objectAt(i)) ++e.underMask[id];
    }
    if (movable[e.classId] && isMostlyNew(e)) {  // only then does anybody ask
      e.placeWasEmpty = wasSeenThrough(cloud, placesOf(detection, seen.samples), range_m);
    }
  }
  return evidence;
}

}  // namespace wardslam::mapping
