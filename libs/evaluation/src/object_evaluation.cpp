#include "wardslam/evaluation/object_evaluation.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace wardslam::evaluation {
namespace {

constexpr double kNear_m = 0.25;
constexpr double kOverlap = 0.25;
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

double intersectionOverUnion(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  const Eigen::AlignedBox3d shared = a.intersection(b);
  if (shared.isEmpty()) return 0.0;
  return shared.volume() / (a.volume() + b.volume() - shared.volume());
}

double centerDistance_m(const TrueObject& truth, const FoundObject& found) {
  return (truth.box_m.center() - found.box_m.center()).norm();
}

bool canMatch(const TrueObject& truth, const FoundObject& found) {
  return truth.classId == found.classId &&
         (centerDistance_m(truth, found) < kNear_m || intersectionOverUnion(truth.box_m, found.box_m) > kOverlap ||
          truth.box_m.contains(found.centroid_m));
}

/// Largest one-to-one matching by augmenting paths (Kuhn's algorithm), nearer partners first. Returns for each found
/// object the true one, or kNobody.
std::vector<std::size_t> match(const std::vector<TrueObject>& truth, const std::vector<FoundObject>& found) {
  std::vector<std::vector<std::size_t>> partners(truth.size());
  for (std::size_t t = 0; t < truth.size(); ++t) {
    for (std::size_t f = 0; f < found.size(); ++f) {
      if (canMatch(truth[t], found[f])) partners[t].push_back(f);
    }
    std::stable_sort(partners[t].begin(), partners[t].end(), [&](std::size_t a, std::size_t b) {
      return centerDistance_m(truth[t], found[a]) < centerDistance_m(truth[t], found[b]);
    });
  }
  std::vector<std::size_t> truthOf(found.size(), kNobody);
  std::vector<bool> isTried;
  const std::function<bool(std::size_t)> place = [&](std::size_t t) {
    return std::any_of(partners[t].begin(), partners[t].end(), [&](std::size_t f) {
      if (isTried[f]) return false;
      isTried[f] = true;
      if (truthOf[f] != kNobody && !place(truthOf[f])) return false;
      truthOf[f] = t;
      return true;
    });
  };
  for (std::size_t t = 0; t < truth.size(); ++t) {
    isTried.assign(found.size(), false);
    place(t);
  }
  return truthOf;
}

/// Height last, the longer horizontal side first.
Eigen::Vector3d sorted(Eigen::Vector3d size_m) {
  if (size_m.x() < size_m.y()) std::swap(size_m.x(), size_m.y());
  return size_m;
}

double ratio(std::size_t part, std::size_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double ClassScore::recall() const { return ratio(wantedFound, wanted); }
double ClassScore::precision() const { return ratio(foundTrue, found); }

ObjectEvaluation evaluateObjects(const std::vector<TrueObject>& truth, const std::vector<FoundObject>& found,
                                 const SeenWell& seenWell) {
  ObjectEvaluation result;
  result.all.className = "all";
  const auto count = [&](core::ClassId id, const std::string& name, std::size_t ClassScore::*what) {
    ClassScore& score = result.classes[id];
    score.className = name;
    ++(score.*what);
    ++(result.all.*what);
  };
  const auto isWanted = [&](const TrueObject& t) {
    return t.framesVisible >= seenWell.frames && t.maxPixels >= seenWell.pixels;
  };
  const std::vector<std::size_t> truthOf = match(truth, found);
  std::vector<double> centers_m;
  std::vector<double> sizes_m;
  for (const TrueObject& t : truth) {
    if (isWanted(t)) count(t.classId, t.className, &ClassScore::wanted);
  }
  for (std::size_t f = 0; f < found.size(); ++f) {
    count(found[f].classId, found[f].className, &ClassScore::found);
    if (truthOf[f] == kNobody) continue;
    const TrueObject& t = truth[truthOf[f]];
    count(found[f].classId, found[f].className, &ClassScore::foundTrue);
    if (isWanted(t)) count(t.classId, t.className, &ClassScore::wantedFound);
    result.matches.emplace_back(truthOf[f], f);
    centers_m.push_back(centerDistance_m(t, found[f]));
    const Eigen::Vector3d size_m = found[f].orientedSize_m.value_or(found[f].box_m.sizes());
    sizes_m.push_back((sorted(size_m) - sorted(t.box_m.sizes())).norm());
  }
  result.center_m = summarise(centers_m);
  result.size_m = summarise(sizes_m);
  return result;
}

std::vector<FoundObject> transformed(std::vector<FoundObject> objects, const Eigen::Isometry3d& T_truth_map) {
  for (FoundObject& object : objects) {
    object.centroid_m = T_truth_map * object.centroid_m;
    object.box_m = object.box_m.transformed(T_truth_map);
  }
  return objects;
}

}  // namespace wardslam::evaluation
