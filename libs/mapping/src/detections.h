#pragma once

#include <map>
#include <vector>

#include "view_samples.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/semantic_cloud_tile.h"

namespace wardslam::mapping {

/// An instance of a view, in space.
struct Detection {
  core::ClassId classId = 0;
  float confidence = 1.0F;
  std::vector<std::size_t> samples;   ///< That belong to the thing.
  std::vector<std::size_t> doubtful;  ///< Inside its mask, but off the thing by their depth.
  Eigen::Vector3f centroid_m = Eigen::Vector3f::Zero();
};

/// The instances of the view that take up space. Of each the Euclidean cluster with most pixels is the thing; so are
/// clusters at no other depth, for something before a thing may cut it in parts. What the mask shows before or behind
/// is doubtful: background it bleeds onto, or what hides it. In the order of instances; no classes of `moving`.
[[nodiscard]] std::vector<Detection> detect(const core::Segmentation& segmentation, const std::vector<Sample>& samples,
                                            const knowledge::ClassSet& moving, const ObjectOptions& options,
                                            float cell_m);

}  // namespace wardslam::mapping
