#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>

#include "wardslam/core/frame.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/options.h"

namespace wardslam::masks {
class AsyncSegmenter;
}
namespace wardslam::knowledge {
class KnowledgeGraph;
}

namespace wardslam::filters {

/// What a filter may use besides its own parameters. Both pointers may be null; a filter that needs it says so.
struct FilterContext {
  std::shared_ptr<masks::AsyncSegmenter> segmenter;
  std::shared_ptr<const knowledge::KnowledgeGraph> knowledge;
  bool deterministic = false;  ///< The run must repeat exactly: nothing may depend on how long work takes.
};

/// A link of the chain between the sensor and the odometry. It looks at a frame and marks what must not be trusted:
/// Keypoint::motion, and pixels (core::addDynamic() and its neighbours), from which Frame::observation is annotated
/// after the last link. What the links before it found, it reads there.
///
/// Filters are made by class name through MRPT's run-time class registry, so that one may live in a plug-in library.
class ObservationFilter : public mrpt::rtti::CObject {
  WARDSLAM_DEFINE_VIRTUAL_MRPT_OBJECT(ObservationFilter, wardslam::filters)

 public:
  /// Once, before the first frame. Throws core::InputError on unknown keys, bad values or a missing context.
  virtual void initialize(const core::ConfigNode& parameters, const FilterContext& context) = 0;

  /// Start work that needs only the images (Frame::features is still empty); must not block. It runs while the
  /// caller extracts key points (P1).
  virtual void begin(const core::Frame& /*frame*/) {}

  /// Mark the frame. Trouble goes to Frame::events.
  virtual void apply(core::Frame& frame) = 0;

  /// After tracking: where the camera was, p_map = T_map_cam * p_cam; nothing while it is lost. The map may be
  /// corrected between frames, so poses of different frames agree only nearly.
  virtual void end(const core::Frame& /*frame*/, const std::optional<Eigen::Isometry3d>& /*T_map_cam*/) {}

  /// The parameters in effect as YAML (core::writeOptions) with the given indentation.
  [[nodiscard]] virtual std::string parameters(int indent) const = 0;
};

}  // namespace wardslam::filters
