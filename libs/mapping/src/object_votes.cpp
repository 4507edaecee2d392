#include "object_votes.h"

#include <algorithm>
#include <utility>

namespace wardslam::mapping {
namespace {

/// What a point has learnt may be unlearnt: when the strongest vote gets stronger than this, all lose half.
constexpr float kStrongest = 20.0F;

}  // namespace

void ObjectVotes::add(ObjectId object, float weight) {
  if (weight <= 0) return;
  const auto same = std::find_if(votes_.begin(), votes_.end(),
                                 [&](const ObjectVote& v) { return v.weight > 0 && v.object == object; });
  if (same != votes_.end()) {
    same->weight += weight;
    bound();
    return;
  }
  const auto weakest = std::min_element(votes_.begin(), votes_.end(),
                                        [](const ObjectVote& a, const ObjectVote& b) { return a.weight < b.weight; });
  if (weight > weakest->weight) {
    *weakest = {object, weight - weakest->weight};
  } else {
    weakest->weight -= weight;
  }
}

void ObjectVotes::add(const ObjectVotes& others) {
  for (const ObjectVote& vote : others.votes_) add(vote.object, vote.weight);
}

void ObjectVotes::rename(ObjectId from, ObjectId into) {
  for (ObjectVote& vote : votes_) {
    if (vote.weight <= 0 || vote.object != from) continue;
    const float weight = std::exchange(vote.weight, 0.0F);
    add(into, weight);
  }
}

ObjectId ObjectVotes::winner() const {
  const auto best = std::max_element(votes_.begin(), votes_.end(),
                                     [](const ObjectVote& a, const ObjectVote& b) { return a.weight < b.weight; });
  return best->object;
}

void ObjectVotes::bound() {
  const bool isStrong =
      std::any_of(votes_.begin(), votes_.end(), [](const ObjectVote& v) { return v.weight > kStrongest; });
  if (!isStrong) return;
  for (ObjectVote& vote : votes_) vote.weight /= 2;
}

}  // namespace wardslam::mapping
