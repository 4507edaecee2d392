#pragma once

#include <memory>
#include <optional>
#include <string>

#include "wardslam/core/frame.h"
#include "wardslam/core/label_space.h"
#include "wardslam/core/profiler.h"
#include "wardslam/features/orb_extractor.h"
#include "wardslam/filters/filter_chain.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/ground_watch.h"
#include "wardslam/odometry/odometry.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/sources/frame_builder.h"

namespace wardslam::pipeline {

/// What comes before the map: from an observation to a frame in which what moves is marked, and to the camera's pose
/// against the local map of odometry. Its memory is bounded, so it may run for as long as a sensor does.
///
///     FrontEnd frontEnd(readSlamOptions("wardslam.yaml"));
///     frontEnd.process(observation);  // the observation is annotated now
class FrontEnd {
 public:
  struct Result {
    core::Frame frame;
    odometry::OdometryResult odometry;
  };

  /// Throws core::InputError when a file the options name is missing or wrong.
  explicit FrontEnd(const SlamOptions& options, const odometry::Continuation& earlier = {});

  /// What is known of the camera beside what its observations tell (sources::ObservationSource::sensorTraits).
  void setSensorTraits(const core::SensorTraits& traits) { frameBuilder_.setSensorTraits(traits); }

  /// Call in order of time. Throws core::FrameError for an observation that cannot be used: leave it out and go on;
  /// core::InputError for what no later observation mends. Annotates the observation with what the filters found,
  /// unless SlamOptions::annotate forbids it. `motion`: of the robot's base since the observation before.
  Result process(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& observation,
                 const std::optional<odometry::MotionPrior>& motion = {});

  /// Takes over what the map found out.
  void apply(const std::shared_ptr<const odometry::MapUpdate>& update);

  /// After the last observation. Throws core::InputError when the run as a whole shows a wrong set-up.
  void requireSoundSetup();

  [[nodiscard]] const filters::FilterChain& filters() const { return filters_; }
  [[nodiscard]] const core::LabelSpace& labelSpace() const { return labels_; }
  [[nodiscard]] knowledge::ClassSet movers() const;    ///< Classes that move by themselves.
  [[nodiscard]] knowledge::ClassSet movables() const;  ///< Classes that somebody can move.
  [[nodiscard]] core::Profiler& profiler() { return profiler_; }
  [[nodiscard]] const core::Profiler& profiler() const { return profiler_; }

 private:
  MapFrameOptions mapFrame_;
  bool annotates_;
  std::shared_ptr<const knowledge::KnowledgeGraph> knowledge_;
  std::shared_ptr<masks::AsyncSegmenter> segmenter_;  ///< Null where nothing segments.
  core::LabelSpace labels_;
  sources::FrameBuilder frameBuilder_;
  features::OrbExtractor features_;
  filters::FilterChain filters_;
  odometry::Odometry odometry_;
  mapping::GroundWatch groundWatch_;
  /// Where the camera goes without corrections of the map, which filters would take for its motion.
  Eigen::Isometry3d T_odom_map_ = Eigen::Isometry3d::Identity();
  core::Profiler profiler_;
};

}  // namespace wardslam::pipeline
