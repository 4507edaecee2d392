#pragma once

#include <future>
#include <optional>
#include <string>

#include "wardslam/change/moving_regions.h"
#include "wardslam/change/scene_motion.h"
#include "wardslam/filters/observation_filter.h"

namespace wardslam::filters {

struct GeometricMotionOptions {
  change::SceneMotionOptions motion;
  change::MovingRegionsOptions regions;
  double min_kept = 0.1;
  bool annotate = true;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    change::SceneMotionOptions::describe(self.motion, visit);
    change::MovingRegionsOptions::describe(self.regions, visit);
    visit("min_kept", self.min_kept, {0.0, 1.0}, "", "where fewer key points would stay static, none is marked");
    visit("annotate", self.annotate, "write what moves into pixelLabels and confidenceImage of the observation");
  }
};

/// Rejects what moves by geometry alone: people the network missed, things no network knows.
///
///     filters:
///       - class_name: wardslam::filters::GeometricMotionFilter
///         params:
///           points: 500
///           window: 0.5
///           reach: 0.4
///
/// Needs neither masks nor knowledge. Behind a filter that does, it only adds to what was marked, and takes what was
/// marked for moving when it looks for the motion of the camera. Events: "filters.motion_unknown" (the motion of the
/// camera could not be told; nothing new was found) and "filters.motion_everywhere" (more than 1 - min_kept moves; not
/// believed).
class GeometricMotionFilter : public ObservationFilter {
  DEFINE_MRPT_OBJECT(GeometricMotionFilter, wardslam::filters)

 public:
  void initialize(const core::ConfigNode& parameters, const FilterContext& context) override;
  void begin(const core::Frame& frame) override;  ///< Follows points in a thread of its own, beside ORB.
  void apply(core::Frame& frame) override;
  [[nodiscard]] std::string parameters(int indent) const override;

 private:
  GeometricMotionOptions options_;
  std::optional<change::SceneMotion> motion_;
  std::future<void> following_;  ///< Uses motion_; must go first.
};

}  // namespace wardslam::filters
