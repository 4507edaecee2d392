#pragma once

#include "gates/gates_support.h"

namespace wardslam::gates {

/// How far the results of one run contradict each other, at most, in metres. The map file at rest against
/// trajectory.txt: each keyframe against the pose of its image, and what hangs on it.
struct Disagreement {
  std::size_t keyframes = 0;
  std::size_t cloudPoints = 0;
  std::size_t objects = 0;

  double keyframe_m = 0.0;  ///< Keyframes from the poses in the trajectory.
  double cloud_m = 0.0;     ///< Points of the cloud from where the trajectory puts them.
  double object_m = 0.0;    ///< Centroids of things from those of their points, put where the trajectory says.
  /// The same within the file alone: put where its keyframes say.
  double objectInFile_m = 0.0;
};

/// How smoothly the poses of a run follow the truth across corrections of the map, in metres.
struct Continuity {
  double step_m = 0.0;       ///< Largest error from one image to the next, in trajectory.txt.
  double liveInEnd_m = 0.0;  ///< Farthest that live poses lie from trajectory.txt, over the last seconds.
};

/// For a whole rendering. Prints what it finds.
[[nodiscard]] Continuity continuityOf(const Rendering& rendering, const Run& run);

/// For a run whose cloud is published whole (kWholeCloud). Prints what it finds.
[[nodiscard]] Disagreement disagreementOf(const Run& run);

/// Configuration (YAML) by which the file holds every point by which things are described.
inline constexpr const char* kWholeCloud = "mapping: {cloud: {min_sightings: 1, max_sigma_m: 1.0}}\n";

}  // namespace wardslam::gates
