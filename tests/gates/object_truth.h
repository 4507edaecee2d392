#pragma once

#include <string>
#include <vector>

#include "gates/gates_support.h"
#include "wardslam/evaluation/object_evaluation.h"

namespace wardslam::gates {

/// What stands in a rendering (objects.csv of its labels), and how well it was seen, counted in its images of
/// instances.
[[nodiscard]] std::vector<evaluation::TrueObject> trueObjects(const Rendering& rendering);

/// The objects of a run in the world of the rendering, by the alignment of the trajectories.
[[nodiscard]] std::vector<evaluation::FoundObject> foundObjects(const Rendering& rendering, const Run& run);

/// Seen well at 320×240: in 15 images, and as large in one as 1500 px of 640×480.
inline constexpr evaluation::SeenWell kSeenWell{15, 375};

/// Where records and things are not one to one; a sentence for each.
struct IdentityFaults {
  std::vector<std::string> twoRecordsOfOneThing;
  std::vector<std::string> oneRecordOfTwoThings;
  std::vector<std::string> ofAnotherClass;
};

[[nodiscard]] IdentityFaults identityFaults(const std::vector<evaluation::TrueObject>& truth,
                                            const std::vector<evaluation::FoundObject>& found);

}  // namespace wardslam::gates
