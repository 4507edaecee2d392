#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "wardslam/change/instance_motion.h"
#include "wardslam/core/frame.h"
#include "wardslam/core/options.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::filters {

struct MovableJudgeOptions {
  double min_probability = 0.3;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_probability", self.min_probability, {0.01, 0.99}, "",
          "rule observed: from which a movable thing counts as moving; missing one costs more than sparing one");
  }
};

/// A movable thing and what speaks for its moving.
struct Verdict {
  enum class Finding : std::uint8_t { Rests, Suspected, Moves };

  core::Instance instance;
  double prior = 0.0;     ///< Log-odds by knowledge: strength where a mover is within reach, else nearly none.
  double evidence = 0.0;  ///< Log-odds by observation; 0 = nothing is known.
  Finding finding = Finding::Rests;

  [[nodiscard]] double probabilityOfMotion() const { return 1.0 / (1.0 + std::exp(-(prior + evidence))); }
};

/// Judges movable things as wholes, by knowledge and by observation (docs/knowledge.md): the facts tell how likely a
/// thing within reach of a mover is being moved, and what was seen of it adds to that or takes from it. What is likely
/// enough to move is said to move when it was seen to, and is suspected otherwise.
class MovableJudge {
 public:
  /// `rules` must outlive this object.
  MovableJudge(const knowledge::MotionRules& rules, const MovableJudgeOptions& options)
      : rules_(rules), options_(options), motion_(rules) {}

  /// Every movable instance of the frame's segmentation, in its order. `movers` (CV_8UC1): the ClassId where something
  /// is that moves by itself, else 0. By observation of the frames before.
  [[nodiscard]] std::vector<Verdict> judge(const core::Frame& frame, const cv::Mat& movers) const;

  /// After tracking: learns from the frame. Nothing is learnt from one whose place is unknown.
  void observe(const core::Frame& frame, const std::optional<Eigen::Isometry3d>& T_map_cam);

 private:
  const knowledge::MotionRules& rules_;
  MovableJudgeOptions options_;
  change::InstanceMotion motion_;
};

}  // namespace wardslam::filters
