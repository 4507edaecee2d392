#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "wardslam/core/segmentation.h"
#include "wardslam/mapping/map_memory.h"
#include "wardslam/mapping/map_object.h"
#include "wardslam/mapping/mapping_options.h"

namespace wardslam::mapping {

/// A detection as the database sees it: where its samples fall on what the cloud has already.
struct Evidence {
  core::ClassId classId = 0;
  float confidence = 1.0F;
  std::size_t size = 0;  ///< Samples of the thing.
  Eigen::Vector3f place_m = Eigen::Vector3f::Zero();
  std::map<ObjectId, std::size_t> onObjects;  ///< Of these, how many fall on points of each object.
  std::map<ObjectId, std::size_t> underMask;  ///< The same of all samples under its mask, the doubtful too.
  bool placeWasEmpty = false;                 ///< Earlier images saw through where it is.
};

/// What is known of an object besides its points, which the cloud has.
struct ObjectRecord : ObjectMemory {
  static constexpr int kConvincingMisses = 5;

  /// Of the run under way, as against those whose map it goes on with: clocks of two runs need not agree.
  struct ThisRun {
    bool isNew = false;   ///< Nobody knew of it before.
    bool isSeen = false;  ///< It was seen.
    bool isLost = false;  ///< It was found to be gone, or in somebody's hands.
  };

  ThisRun thisRun;

  ObjectRecord() = default;
  explicit ObjectRecord(const ObjectMemory& memory) : ObjectMemory(memory) {}

  /// As if all its views had agreed on its class. Of what was told to others there was this much evidence.
  [[nodiscard]] static ObjectRecord from(const MapObject& object, double least_evidence = 0.0);

  [[nodiscard]] core::ClassId classId() const;
  /// Since it was seen last it was missed more often than it was ever seen: it may have been taken away.
  [[nodiscard]] bool isMissing() const { return missed >= kConvincingMisses && missed > views; }

  [[nodiscard]] double evidence() const;  ///< Sum of the confidences of all its detections.
  [[nodiscard]] double probability() const;
};

/// Which detections of many views are one thing (P9). Instance ids are of no use for that: they need not be the same
/// in two images. Points of the cloud are: a detection shows the object on whose points it falls.
class ObjectDatabase {
 public:
  explicit ObjectDatabase(const ObjectOptions& options) : options_(options) {}

  /// An object of an earlier map.
  void restore(ObjectId id, const ObjectRecord& record) { objects_[id] = record; }
  void restore(const std::map<std::pair<ObjectId, ObjectId>, PairMemory>& pairs) {
    for (const auto& [pair, memory] : pairs) {
      relations_[pair] = memory;
      moreTogether_.insert(pair);
    }
  }

  /// The object each detection of one view shows; new ones get an id from `nextId`. `inSight`: how many points of each
  /// object the view sees.
  std::vector<ObjectId> observe(const std::vector<Evidence>& detections, const std::map<ObjectId, std::size_t>& inSight,
                                double stamp_s, ObjectId& nextId);

  /// A thing of this class is there, and may be moving: it is in somebody's hands. Call before observe().
  void noteHandled(core::ClassId classId, const Eigen::Vector3f& place_m, double stamp_s);

  /// Points of these objects were seen through and taken away. `left`: what remains of each. Returns the objects that
  /// are gone by that.
  std::vector<ObjectId> erase(const std::map<ObjectId, std::size_t>& points,
                              const std::map<ObjectId, std::size_t>& left, double stamp_s);

  /// It was taken away between two runs: since it was seen last, nobody knows when.
  void lose(ObjectId id, double lastSeen_s);
  /// Another run had seen nothing where it stands, before it was first seen there.
  void noteEmptyPlace(ObjectId id) { objects_.at(id).placeWasEmpty = true; }

  /// A thing that was lost and the same thing, seen since at another place, are one that moved; it keeps its first id.
  void reunite(ObjectId lost, ObjectId found);

  /// Objects that turned out to be others, since the last call: {from, into}.
  [[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>> takeMerges() { return std::exchange(merges_, {}); }

  /// The two are one thing.
  void merge(ObjectId from, ObjectId into);

  [[nodiscard]] const std::map<ObjectId, ObjectRecord>& objects() const { return objects_; }
  [[nodiscard]] const std::map<std::pair<ObjectId, ObjectId>, PairMemory>& pairs() const { return relations_; }

  /// Whether images showed the two as two things more often than as one.
  [[nodiscard]] bool areSeenAsOne(ObjectId a, ObjectId b) const;  ///< By more images than told them apart.
  [[nodiscard]] bool areApart(ObjectId a, ObjectId b) const;

  void absorb(ObjectDatabase&& other);

 private:
  struct Handling {
    core::ClassId classId = 0;
    Eigen::Vector3f place_m = Eigen::Vector3f::Zero();
    double stamp_s = 0.0;
  };
  struct Match {
    double overlap = 0.0;
    std::size_t detection = 0;
    ObjectId object = 0;
  };

  [[nodiscard]] std::vector<Match> candidates(const std::vector<Evidence>& detections,
                                              const std::map<ObjectId, std::size_t>& inSight) const;
  void relate(const std::vector<Evidence>& detections, const std::vector<ObjectId>& assigned,
              const std::map<ObjectId, std::size_t>& inSight);
  void mergeRelated();
  void markHandled(double stamp_s);

  ObjectOptions options_;
  std::map<ObjectId, ObjectRecord> objects_;
  std::map<std::pair<ObjectId, ObjectId>, PairMemory> relations_;  ///< The lesser id first.
  std::set<std::pair<ObjectId, ObjectId>> moreTogether_;  ///< Of relations_, those that may have come to say one thing.
  std::vector<std::pair<ObjectId, ObjectId>> merges_;
  std::vector<Handling> handlings_;  ///< Of the last seconds.
};

}  // namespace wardslam::mapping
