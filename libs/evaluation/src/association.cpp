#include "wardslam/evaluation/association.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace wardslam::evaluation {
namespace {

struct Candidate {
  double difference_s;
  PosePair pair;
};

std::vector<Candidate> findCandidates(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                      double maxDifference_s) {
  std::vector<Candidate> candidates;
  std::size_t windowBegin = 0;
  for (std::size_t g = 0; g < groundTruth.size(); ++g) {
    const double stamp_s = groundTruth[g].stamp_s;
    while (windowBegin < estimate.size() && stamp_s - estimate[windowBegin].stamp_s >= maxDifference_s) ++windowBegin;
    for (std::size_t e = windowBegin; e < estimate.size(); ++e) {
      if (estimate[e].stamp_s - stamp_s >= maxDifference_s) break;
      candidates.push_back({std::abs(stamp_s - estimate[e].stamp_s), {g, e}});
    }
  }
  return candidates;
}

}  // namespace

std::vector<PosePair> associate(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                double maxDifference_s) {
  std::vector<Candidate> candidates = findCandidates(groundTruth, estimate, maxDifference_s);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.difference_s, a.pair.groundTruth, a.pair.estimate) <
           std::tie(b.difference_s, b.pair.groundTruth, b.pair.estimate);
  });

  std::vector<PosePair> pairs;
  std::vector<bool> groundTruthTaken(groundTruth.size());
  std::vector<bool> estimateTaken(estimate.size());
  for (const auto& [difference_s, pair] : candidates) {
    if (groundTruthTaken[pair.groundTruth] || estimateTaken[pair.estimate]) continue;
    groundTruthTaken[pair.groundTruth] = estimateTaken[pair.estimate] = true;
    pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const PosePair& a, const PosePair& b) { return a.groundTruth < b.groundTruth; });
  return pairs;
}

}  // namespace wardslam::evaluation
