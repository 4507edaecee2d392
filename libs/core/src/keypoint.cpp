#include "wardslam/core/keypoint.h"

namespace wardslam::core {

std::optional<double> differenceOf(const SemanticDescriptor& a, const SemanticDescriptor& b) {
  if (a.empty() || a.size() != b.size()) return std::nullopt;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i] ? 1 : 0;
  return static_cast<double>(different) / static_cast<double>(a.size());
}

Features selectStatic(const Features& features) {
  Features kept;
  kept.semanticDescriptors = features.semanticDescriptors;
  kept.keypoints.reserve(features.size());
  kept.descriptors.reserve(features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features.keypoints[i].motion == Motion::Dynamic) continue;
    kept.keypoints.push_back(features.keypoints[i]);
    kept.descriptors.push_back(features.descriptors.row(static_cast<int>(i)));
  }
  return kept;
}

}  // namespace wardslam::core
