#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/label_space.h"
#include "wardslam/core/profiler.h"
#include "wardslam/mapping/zones.h"
#include "wardslam/odometry/odometry.h"
#include "wardslam/pipeline/earlier_map.h"
#include "wardslam/pipeline/frame_observer.h"
#include "wardslam/pipeline/front_end.h"
#include "wardslam/pipeline/map_keeper.h"
#include "wardslam/pipeline/scene_keeper.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/pipeline/trajectory_recorder.h"

namespace wardslam::pipeline {

/// From observations to the camera's pose among moving people: the main loop.
///
///     SlamSystem slam(readSlamOptions("wardslam.yaml"));
///     while (auto observation = source->next()) std::cout << slam.process(observation).T_map_cam.matrix();
class SlamSystem {
 public:
  /// Throws core::InputError when a file the options name is missing or wrong, or when the class names of the earlier
  /// map contradict those in use.
  explicit SlamSystem(const SlamOptions& options, const EarlierMap& earlier = {});

  /// How sure the depth of the observations to come is (sources::ObservationSource::depthNoise); a Kinect's unless
  /// told.
  void setDepthNoise(const core::DepthNoise& noise) { frontEnd_.setDepthNoise(noise); }

  /// Call in order of time. Throws core::FrameError for an observation that cannot be used: leave it out and go on;
  /// core::InputError for what no later observation mends. Annotates the observation.
  odometry::OdometryResult process(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& observation);

  /// After the last observation: waits for what is still being worked into the map.
  void finish();

  /// After the last observation. Throws core::InputError when the run as a whole shows a wrong set-up.
  void requireSoundSetup() { frontEnd_.requireSoundSetup(); }

  /// Every tracked frame, by the map as it is in the end. After finish().
  [[nodiscard]] core::Trajectory trajectory() const;

  /// Keyframes, points and loops. After finish().
  [[nodiscard]] const graph::Mapper& map() const { return *finishedMap_; }

  /// Coloured cloud and objects (P8-P10). After finish(); empty when `mapping.enabled` is false.
  [[nodiscard]] mapping::SemanticMap semanticMap() const;

  /// The work on the semantic map; null when `mapping.enabled` is false.
  [[nodiscard]] SceneKeeper* scene() const { return scene_.get(); }

  /// Time of the first image from which on the earlier map was recognised. Nothing: it was not, or there is none.
  [[nodiscard]] std::optional<double> recognisedAt_s() const { return recognisedAt_s_; }

  /// Must outlive this object.
  void addObserver(FrameObserver& observer) { observers_.push_back(&observer); }

  /// All options in effect, as commented YAML that readSlamOptions() takes.
  [[nodiscard]] std::string configuration() const;

  [[nodiscard]] const core::LabelSpace& labelSpace() const { return frontEnd_.labelSpace(); }
  [[nodiscard]] const mapping::Zones& zones() const { return zones_; }
  [[nodiscard]] const core::Profiler& profiler() const { return frontEnd_.profiler(); }

 private:
  SlamOptions options_;
  FrontEnd frontEnd_;
  mapping::Zones zones_;
  MapKeeper map_;
  const graph::Mapper* finishedMap_ = nullptr;
  bool hasEarlierMap_ = false;
  std::optional<double> recognisedAt_s_;
  TrajectoryRecorder trajectory_;
  std::vector<FrameObserver*> observers_;
  std::unique_ptr<SceneKeeper> scene_;
};

}  // namespace wardslam::pipeline
