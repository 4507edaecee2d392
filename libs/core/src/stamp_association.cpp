#include "wardslam/core/stamp_association.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace wardslam::core {
namespace {

/// Difference, index into a, index into b: sorts in the order in which pairs are taken.
using Candidate = std::tuple<double, std::size_t, std::size_t>;

std::vector<Candidate> findCandidates(const std::vector<double>& a_s, const std::vector<double>& b_s,
                                      double maxDifference_s) {
  std::vector<Candidate> candidates;
  std::size_t windowBegin = 0;
  for (std::size_t i = 0; i < a_s.size(); ++i) {
    while (windowBegin < b_s.size() && a_s[i] - b_s[windowBegin] >= maxDifference_s) ++windowBegin;
    for (std::size_t j = windowBegin; j < b_s.size() && b_s[j] - a_s[i] < maxDifference_s; ++j) {
      candidates.emplace_back(std::abs(a_s[i] - b_s[j]), i, j);
    }
  }
  return candidates;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> associateByStamp(const std::vector<double>& a_s,
                                                                  const std::vector<double>& b_s,
                                                                  double maxDifference_s) {
  std::vector<Candidate> candidates = findCandidates(a_s, b_s, maxDifference_s);
  std::sort(candidates.begin(), candidates.end());

  std::vector<bool> aTaken(a_s.size());
  std::vector<bool> bTaken(b_s.size());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [difference_s, i, j] : candidates) {
    if (aTaken[i] || bTaken[j]) continue;
    aTaken[i] = bTaken[j] = true;
    pairs.emplace_back(i, j);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace wardslam::core
