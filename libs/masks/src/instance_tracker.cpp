#include "wardslam/masks/instance_tracker.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "wardslam/segmentation/instance_images.h"

namespace wardslam::masks {
namespace {

constexpr double kMinIou = 0.3;
constexpr double kMinPartLeft = 0.5;
constexpr int kMinRegion_px = 100;
constexpr float kLastConfidence = 0.25F;  ///< Of that when last seen, at the end of its time.

using Id = std::uint16_t;

/// How many pixels two pictures' instances have, each and in common; (0, id) and (id, 0) are in `common` too.
struct Overlaps {
  std::map<Id, int> detected_px;
  std::map<Id, int> carried_px;
  std::map<std::pair<Id, Id>, int> common_px;
};

Overlaps countOverlaps(const cv::Mat& detectedIds, const cv::Mat& carriedIds) {
  Overlaps overlaps;
  for (int y = 0; y < detectedIds.rows; ++y) {
    const auto* detected = detectedIds.ptr<Id>(y);
    const auto* carried = carriedIds.ptr<Id>(y);
    for (int begin = 0, end = 0; begin < detectedIds.cols; begin = end) {
      for (end = begin; end < detectedIds.cols && detected[end] == detected[begin] && carried[end] == carried[begin];) {
        ++end;
      }
      const std::pair key(detected[begin], carried[begin]);
      if (key == std::pair<Id, Id>(0, 0)) continue;
      overlaps.detected_px[key.first] += end - begin;
      overlaps.carried_px[key.second] += end - begin;
      overlaps.common_px[key] += end - begin;
    }
  }
  return overlaps;
}

std::map<Id, core::ClassId> classesOf(const core::Segmentation& segmentation) {
  std::map<Id, core::ClassId> classes;
  for (const auto& instance : segmentation.instances) classes[instance.id] = instance.classId;
  return classes;
}

/// Detected id -> carried id, the best overlaps first.
std::map<Id, Id> match(const core::Segmentation& detected, const core::Segmentation& carried) {
  std::map<Id, Id> matches;
  if (carried.instances.empty()) return matches;
  const Overlaps overlaps = countOverlaps(detected.instanceIds, carried.instanceIds);
  const auto detectedClasses = classesOf(detected);
  const auto carriedClasses = classesOf(carried);
  std::vector<std::tuple<double, Id, Id>> pairs;
  for (const auto& [ids, common_px] : overlaps.common_px) {
    const auto a = detectedClasses.find(ids.first);
    const auto b = carriedClasses.find(ids.second);
    if (a == detectedClasses.end() || b == carriedClasses.end() || a->second != b->second) continue;
    const int united_px = overlaps.detected_px.at(ids.first) + overlaps.carried_px.at(ids.second) - common_px;
    const double iou = static_cast<double>(common_px) / united_px;
    if (iou >= kMinIou) pairs.emplace_back(-iou, ids.first, ids.second);
  }
  std::sort(pairs.begin(), pairs.end());
  std::set<Id> taken;
  for (const auto& [order, detectedId, carriedId] : pairs) {
    if (matches.count(detectedId) > 0 || !taken.insert(carriedId).second) continue;
    matches[detectedId] = carriedId;
  }
  return matches;
}

void renumber(cv::Mat& ids, const std::map<Id, Id>& newIds) {
  for (int y = 0; y < ids.rows; ++y) {
    auto* row = ids.ptr<Id>(y);
    for (int begin = 0, end = 0; begin < ids.cols; begin = end) {
      const Id old = row[begin];
      for (end = begin; end < ids.cols && row[end] == old;) ++end;
      if (old == 0) continue;
      const auto found = newIds.find(old);
      std::fill(row + begin, row + end, found == newIds.end() ? Id{0} : found->second);
    }
  }
}

/// A copy in which every instance has an id.
core::Segmentation withInstances(const core::Segmentation& detected) {
  core::Segmentation result = detected;
  result.classIds = detected.classIds.clone();
  result.instanceIds = detected.instanceIds.clone();
  if (result.instanceIds.empty() && !result.classIds.empty()) {
    result.instanceIds = segmentation::labelRegions(result.classIds, kMinRegion_px);
    result.instances = segmentation::listInstances(result.classIds, result.instanceIds);
  }
  return result;
}

core::Segmentation nothing(cv::Size size) {
  return {cv::Mat(size, CV_8UC1, cv::Scalar(0)), cv::Mat(size, CV_16UC1, cv::Scalar(0)), {}};
}

}  // namespace

core::Segmentation InstanceTracker::update(const core::Segmentation& detected, const core::Segmentation& carried,
                                           double stamp_s) {
  if (detected.empty() && carried.empty()) {
    tracks_.clear();
    return {};
  }
  core::Segmentation result = detected.empty() ? nothing(carried.classIds.size()) : withInstances(detected);
  identify(result, carried, stamp_s);
  keepMissed(carried, stamp_s, result);
  forgetAbsent(result);
  const bool isSegmented = !detected.empty() || !result.instances.empty();
  return isSegmented ? result : core::Segmentation{};
}

void InstanceTracker::identify(core::Segmentation& detected, const core::Segmentation& carried, double stamp_s) {
  const std::map<Id, Id> matches = match(detected, carried);
  std::map<Id, Id> newIds;
  for (core::Instance& instance : detected.instances) {
    const auto matched = matches.find(instance.id);
    const bool isNew = matched == matches.end();
    const Id id = isNew ? newId() : matched->second;
    Track& track = tracks_[id];
    if (isNew) track.firstSeen_s = stamp_s;
    track.lastSeen_s = stamp_s;
    track.confidence = instance.confidence;
    newIds[instance.id] = id;
    instance.id = id;
  }
  renumber(detected.instanceIds, newIds);
}

void InstanceTracker::keepMissed(const core::Segmentation& carried, double stamp_s, core::Segmentation& result) const {
  const cv::Rect image({}, result.classIds.size());
  for (core::Instance instance : carried.instances) {
    const auto track = tracks_.find(instance.id);
    if (track == tracks_.end() || track->second.lastSeen_s >= stamp_s) continue;
    const double missed_s = stamp_s - track->second.lastSeen_s;
    const double patience_s = patienceFor_s(track->second);
    const cv::Rect box = instance.box_px & image;
    if (missed_s > patience_s || box.empty()) continue;

    const cv::Mat mask = carried.instanceIds(box) == instance.id;
    const cv::Mat left = mask & (result.classIds(box) == 0);
    if (cv::countNonZero(left) < kMinPartLeft * cv::countNonZero(mask)) continue;
    result.classIds(box).setTo(instance.classId, left);
    result.instanceIds(box).setTo(instance.id, left);
    instance.box_px = cv::boundingRect(left) + box.tl();
    instance.confidence =
        track->second.confidence * std::pow(kLastConfidence, static_cast<float>(missed_s / patience_s));
    result.instances.push_back(instance);
  }
}

double InstanceTracker::patienceFor_s(const Track& track) const {
  return std::min(options_.bridge_s, track.lastSeen_s - track.firstSeen_s);
}

std::uint16_t InstanceTracker::newId() {
  do {
    ++lastId_;
  } while (lastId_ == 0 || tracks_.count(lastId_) > 0);
  return lastId_;
}

void InstanceTracker::forgetAbsent(const core::Segmentation& present) {
  const auto classes = classesOf(present);
  for (auto track = tracks_.begin(); track != tracks_.end();) {
    track = classes.count(track->first) > 0 ? std::next(track) : tracks_.erase(track);
  }
}

}  // namespace wardslam::masks
