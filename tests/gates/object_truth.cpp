#include "gates/object_truth.h"

#include <map>
#include <sstream>

#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/object_files.h"

namespace wardslam::gates {
namespace {

constexpr double kSamePlace = 0.5;  ///< Part of a box that lies in another.

double partInside(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& other) {
  const Eigen::AlignedBox3d shared = box.intersection(other);
  return shared.isEmpty() || box.volume() <= 0 ? 0.0 : shared.volume() / box.volume();
}

std::string text(const evaluation::FoundObject& found) {
  std::ostringstream out;
  out << "#" << found.id << " " << found.className << " at " << found.centroid_m.transpose();
  return out.str();
}

}  // namespace

std::vector<evaluation::TrueObject> trueObjects(const Rendering& rendering) {
  return evaluation::readTrueObjects(rendering.labels() / "objects.csv");
}

std::vector<evaluation::FoundObject> foundObjects(const Rendering& rendering, const Run& run) {
  const auto alignment = evaluation::absoluteTrajectoryError(rendering.truth(), run.trajectory());
  return evaluation::transformed(evaluation::readFoundObjects(run.out / "objects.json"),
                                 alignment.T_groundtruth_estimate);
}

IdentityFaults identityFaults(const std::vector<evaluation::TrueObject>& truth,
                              const std::vector<evaluation::FoundObject>& found) {
  const auto matches = evaluation::evaluateObjects(truth, found, kSeenWell).matches;
  std::map<std::size_t, std::size_t> truthOf;
  for (const auto& [t, f] : matches) truthOf[f] = t;
  IdentityFaults faults;
  for (std::size_t f = 0; f < found.size(); ++f) {
    int whole = 0;
    for (const auto& thing : truth) {
      if (thing.classId == found[f].classId && partInside(thing.box_m, found[f].box_m) > kSamePlace) ++whole;
    }
    if (whole > 1) faults.oneRecordOfTwoThings.push_back(text(found[f]));
    if (truthOf.count(f) > 0) continue;
    for (const auto& thing : truth) {
      if (partInside(found[f].box_m, thing.box_m) < kSamePlace) continue;
      auto& list = thing.classId == found[f].classId ? faults.twoRecordsOfOneThing : faults.ofAnotherClass;
      list.push_back(text(found[f]) + " in " + thing.name);
    }
  }
  return faults;
}

}  // namespace wardslam::gates
