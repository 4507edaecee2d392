#pragma once

#include <array>

#include "wardslam/mapping/semantic_cloud_tile.h"

namespace wardslam::mapping {

/// Which object a point belongs to (0 = none), by weighted vote. Holds the few strongest candidates: a new one takes
/// from the weakest until it has its place (Misra and Gries: "Finding repeated elements", 1982).
class ObjectVotes {
 public:
  void add(ObjectId object, float weight);
  void rename(ObjectId from, ObjectId into);
  void add(const ObjectVotes& others);

  [[nodiscard]] ObjectId winner() const;

 private:
  struct Vote {
    ObjectId object = 0;
    float weight = 0.0F;
  };
  void bound();

  std::array<Vote, 3> votes_{};
};

}  // namespace wardslam::mapping
