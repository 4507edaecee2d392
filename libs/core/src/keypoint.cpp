#include "wardslam/core/keypoint.h"

namespace wardslam::core {

Features selectStatic(const Features& features) {
  Features kept;
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
