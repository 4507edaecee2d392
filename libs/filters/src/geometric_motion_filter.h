#pragma once

#include <optional>
#include <string>

#include "wardslam/change/moving_regions.h"
#include "wardslam/change/scene_motion.h"
#include "wardslam/core/side_job.h"
#include "wardslam/filters/observation_filter.h"

namespace wardslam::filters {

struct GeometricMotionOptions {
  change::SceneMotionOptions motion;
  change::MovingRegionsOptions regions;
  double min_kept = 0.1;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    change::SceneMotionOptions::describe(self.motion, visit);
    change::MovingRegionsOptions::describe(self.regions, visit);
    visit("min_kept", self.min_kept, {0.0, 1.0}, "", "where fewer key points would stay static, none is marked");
  }
};

/// Rejects what moves by geometry alone: people the network missed, things no network knows.
///
///     filters:
///       - class_name: wardslam::filters::GeometricMotionFilter
///         params:
///           points: 500       # followed from image to image, at most
///           min_points: 15    # at rest, that a camera motion must rest on
///           min_spread: 0.12  # share of the image they must be spread over
///           window: 0.5       # s, how far back images are compared
///           memory: 0.7       # s, after which a third is left of what was known
///           reach: 0.4        # m, how far motion seen at one place holds along its surface
///           strict: 1         # log-odds from which a point moves that others bear out,
///           loose: 3          # and one that stands alone
///           min_area: 0.01    # m^2, smallest surface that can have come
///           min_kept: 0.1     # share of the key points that must stay static
///
/// Needs neither masks nor knowledge. Sets Keypoint::motion and core::addDynamic(). Behind a filter that has masks, it
/// only adds to what was marked, and takes what was marked for moving when it looks for the motion of the camera.
/// Events: "filters.motion_unknown" (the motion of the camera could not be told; nothing new was found) and
/// "filters.motion_everywhere" (more than 1 - min_kept moves; not believed).
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
  core::SideJob<void> following_;
};

}  // namespace wardslam::filters
