#include "movable_judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "wardslam/change/surface_samples.h"

namespace wardslam::filters {
namespace {

constexpr double kStrengthAlone = 0.03;  ///< That something moves which nobody can reach.

using Points = std::vector<Eigen::Vector3d>;

double logOddsOf(double probability) {
  const double p = std::clamp(probability, 0.001, 0.999);
  return std::log(p / (1.0 - p));
}

/// Surfaces of what moves by itself, per class.
std::map<core::ClassId, Points> surfacesOf(const knowledge::ClassSet& classes, const core::Frame& frame,
                                           const cv::Mat& movers) {
  constexpr int kSamples = 2000;  // of the whole image
  std::map<core::ClassId, Points> surfaces;
  for (std::size_t c = 1; c < classes.size(); ++c) {
    if (!classes[c]) continue;
    const auto id = static_cast<core::ClassId>(c);
    const cv::Rect box = cv::boundingRect(movers == id);
    if (box.empty()) continue;
    surfaces[id] =
        change::sampleSurface(frame, box, kSamples, [&](int y, int x) { return movers.at<core::ClassId>(y, x) == id; });
  }
  return surfaces;
}

/// Where no depth tells how far apart they are, they are taken to be within reach.
bool isWithin(double reach_m, const Points& thing, const Points& mover) {
  return thing.empty() || mover.empty() || change::gapBetween(thing, mover) <= reach_m;
}

Verdict::Finding findingOf(double prior, double evidence, double minProbability) {
  if (prior + evidence <= logOddsOf(minProbability)) return Verdict::Finding::Rests;
  return evidence > 0 ? Verdict::Finding::Moves : Verdict::Finding::Suspected;
}

}  // namespace

std::vector<Verdict> MovableJudge::judge(const core::Frame& frame, const cv::Mat& movers) const {
  constexpr int kSamples = 400;
  const auto surfaces = surfacesOf(rules_.moving(), frame, movers);
  const core::Segmentation& segmentation = frame.segmentation;
  std::vector<Verdict> verdicts;
  for (const core::Instance& instance : segmentation.instances) {
    if (!rules_.isMovable(instance.classId)) continue;
    const Points thing = change::sampleSurface(frame, instance.box_px, kSamples, [&](int y, int x) {
      return segmentation.instanceIds.at<std::uint16_t>(y, x) == instance.id;
    });
    double strength = kStrengthAlone;
    for (const auto& [by, surface] : surfaces) {
      const auto bond = rules_.bond(instance.classId, by);
      if (bond.strength > strength && isWithin(bond.reach_m, thing, surface)) strength = bond.strength;
    }
    const double prior = logOddsOf(strength);
    const double evidence = motion_.evidence(instance.id);
    verdicts.push_back({instance, prior, evidence, findingOf(prior, evidence, options_.min_probability)});
  }
  return verdicts;
}

void MovableJudge::observe(const core::Frame& frame, const std::optional<Eigen::Isometry3d>& T_map_cam) {
  const bool canObserve = T_map_cam && !frame.depth_m.empty() && !frame.segmentation.instanceIds.empty();
  canObserve ? motion_.update(frame, *T_map_cam) : motion_.forgetImages();
}

}  // namespace wardslam::filters
