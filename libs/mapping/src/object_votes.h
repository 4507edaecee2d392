#pragma once

#include <array>

#include "wardslam/mapping/map_memory.h"

namespace wardslam::mapping {

/// Which object a point belongs to (0 = none), by weighted vote. Holds the few strongest candidates: a new one takes
/// from the weakest until it has its place (Misra and Gries: "Finding repeated elements", 1982).
class ObjectVotes {
 public:
  using Votes = std::array<ObjectVote, 3>;

  ObjectVotes() = default;
  explicit ObjectVotes(const Votes& votes) : votes_(votes) {}
  void add(ObjectId object, float weight);
  void rename(ObjectId from, ObjectId into);
  void add(const ObjectVotes& others);

  [[nodiscard]] ObjectId winner() const;
  [[nodiscard]] const Votes& votes() const { return votes_; }

 private:
  void bound();

  Votes votes_{};
};

}  // namespace wardslam::mapping
