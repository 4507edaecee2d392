#pragma once

#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <optional>
#include <set>
#include <string>

#include "keyframe_scans.h"
#include "motion_of_actions.h"
#include "wardslam/mrpt_slam/map_builder_options.h"
#include "wardslam/pipeline/slam_system.h"

namespace wardslam::mrpt_slam {

/// One run, from an initialize() to the next. Not for several threads at once.
class Session : private pipeline::FrameObserver {
 public:
  /// `T_map_base`: where the robot starts; nothing: at the origin. Throws core::InputError for wrong options.
  Session(const MapBuilderConfiguration& configuration, const pipeline::EarlierMap& earlier, bool updatesTheMap,
          const std::optional<Eigen::Isometry3d>& T_map_base);

  /// How the robot moved since the last action; nothing: nobody knows.
  void addMotion(const std::optional<odometry::MotionPrior>& motion);
  void add(const mrpt::obs::CObservationOdometry& reading) { odometer_.add(reading); }
  /// All that was observed at a time, with an image among it or not.
  void add(const mrpt::obs::CSensoryFrame& observed);
  void finish();

  [[nodiscard]] mrpt::poses::CPose3DPDFGaussian pose() const;
  [[nodiscard]] Eigen::Isometry3d T_map_base() const { return T_map_base_; }
  [[nodiscard]] std::size_t keyframes() const { return keyframes_.size(); }
  [[nodiscard]] mrpt::maps::CSimpleMap simpleMap();
  [[nodiscard]] const mrpt::maps::CMultiMetricMap& metricMaps();  ///< Valid until the next call.
  [[nodiscard]] const pipeline::MapSoFar& soFar();                ///< Valid until something is added.

 private:
  Session(const MapBuilderConfiguration& configuration, const pipeline::SlamOptions& slam,
          const pipeline::EarlierMap& earlier);
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;
  void onUpdate(const odometry::MapUpdate& update) override;
  [[nodiscard]] mrpt::obs::CObservation3DRangeScan::Ptr cameraAmong(const mrpt::obs::CSensoryFrame& observed);
  [[nodiscard]] std::optional<odometry::MotionPrior> motionUntil(double stamp_s) const;

  MapBuilderConfiguration configuration_;
  KeyframeScans scans_;
  pipeline::SlamSystem slam_;
  std::set<odometry::KeyframeId> keyframes_;

  std::optional<std::string> camera_;  ///< Label of the sensor that is tracked.
  OdometerMotion odometer_;
  std::optional<odometry::MotionPrior> motion_;  ///< Of actions since the last image.
  bool missedMotion_ = false;                    ///< There was an action that did not tell.
  std::optional<double> lastImage_s_;
  mrpt::obs::CSensoryFrame waiting_;  ///< Seen since the last image.

  std::optional<double> lastSeen_s_;  ///< When there was a pose.
  Eigen::Isometry3d T_map_base_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_base_cam_ = Eigen::Isometry3d::Identity();
  odometry::PoseCovariance covariance_ = odometry::PoseCovariance::Zero();  ///< Of T_map_base_, in the base frame.

  bool isFinished_ = false;
  std::optional<pipeline::MapSoFar> soFar_;  ///< Nothing: something was added since.
  std::optional<mrpt::maps::CMultiMetricMap> metricMaps_;
  bool metricMapsAreOld_ = true;
};

}  // namespace wardslam::mrpt_slam
