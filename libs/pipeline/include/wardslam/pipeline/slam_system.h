#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/event_counts.h"
#include "wardslam/core/label_space.h"
#include "wardslam/core/mailbox.h"
#include "wardslam/core/profiler.h"
#include "wardslam/core/stage.h"
#include "wardslam/graph/mapper.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/mapping/zones.h"
#include "wardslam/odometry/odometry.h"
#include "wardslam/pipeline/earlier_map.h"
#include "wardslam/pipeline/frame_observer.h"
#include "wardslam/pipeline/front_end.h"
#include "wardslam/pipeline/shared_updates.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/pipeline/trajectory_recorder.h"
#include "wardslam/pipeline/when_behind.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::pipeline {

class MapFeed;

/// What a run knows while it goes on.
struct MapSoFar {
  std::map<odometry::KeyframeId, Eigen::Isometry3d> T_map_cam;  ///< Of the keyframes of the map.
  core::Trajectory trajectory;                                  ///< Every frame tracked in the map.
  mapping::SemanticMap semantic;                                ///< Empty when `mapping.enabled` is false.
};

/// From observations to the camera's pose among moving people: the main loop.
///
///     SlamSystem slam(readSlamOptions("wardslam.yaml"));
///     while (auto observation = source->next()) std::cout << slam.process(observation).T_map_cam.matrix();
class SlamSystem {
 public:
  /// Throws core::InputError when a file the options name is missing or wrong, or when the class names of the earlier
  /// map contradict those in use.
  explicit SlamSystem(const SlamOptions& options, const EarlierMap& earlier = {},
                      WhenBehind whenBehind = WhenBehind::LeavesViewsOut);
  ~SlamSystem();  ///< Without finish(), what still waits to be worked into the map is dropped.

  /// What is known of the camera beside what its observations tell (sources::ObservationSource::sensorTraits).
  void setSensorTraits(const core::SensorTraits& traits) { frontEnd_.setSensorTraits(traits); }

  /// Call in order of time. Throws core::FrameError for an observation that cannot be used: leave it out and go on;
  /// core::InputError for what no later observation mends. Annotates the observation. `motion`: of the robot's base
  /// since the observation before, by what is no camera (odometry::isUsable()).
  odometry::OdometryResult process(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& observation,
                                   const std::optional<odometry::MotionPrior>& motion = {});

  /// What all observations until now have come to, once they are worked in; the run may go on after it. After finish():
  /// what there is in the end.
  [[nodiscard]] MapSoFar mapSoFar();

  /// After the last observation, also when process() has thrown: waits for what is still being worked into the map.
  /// Throws what a thread of the map has thrown; the map is then as it was left, and all that is said to hold after
  /// finish() holds.
  void finish();

  /// After the last observation. Throws core::InputError when the run as a whole shows a wrong set-up.
  void requireSoundSetup() { frontEnd_.requireSoundSetup(); }

  /// Every frame tracked in the map, by the map as it is in the end. After finish().
  [[nodiscard]] core::Trajectory trajectory() const;

  /// The frames of this run that were tracked elsewhere, by piece (odometry::Pieces), each in a frame of its own:
  /// tracking was lost and begun anew, and no place was recognised since. After finish().
  [[nodiscard]] std::map<std::uint32_t, core::Trajectory> unjoinedTrajectories() const;

  /// Keyframes, points and loops. After finish().
  [[nodiscard]] const graph::Mapper& mapper() const { return *mapper_; }

  /// Coloured cloud and objects (P8-P10). After finish(); empty when `mapping.enabled` is false.
  [[nodiscard]] mapping::SemanticMap semanticMap() const;

  /// What semanticMap() is built by. After finish(); null when `mapping.enabled` is false.
  [[nodiscard]] mapping::MapBuilder* mapBuilder() const { return mapBuilder_.get(); }

  /// Whether there will be a semantic map (`mapping.enabled`).
  [[nodiscard]] bool buildsSemanticMap() const { return mapFeed_ != nullptr; }

  /// Before the first frame: has every keyframe written into a map file when it is worked in. Without effect when
  /// `mapping.enabled` is false. The writer must outlive this object.
  void writeTo(storage::MapFileWriter& writer);

  /// What did not get into the semantic map: "mapping.view_left_out", views that came faster than they could be worked
  /// in, and "mapping.view_without_masks", those of which nobody knew yet who is in them.
  [[nodiscard]] core::EventCounts leftOut() const;

  /// Keyframes, views and corrections that wait to be worked into graph and map.
  [[nodiscard]] std::size_t waiting() const;

  /// Time of the first image from which on the earlier map was recognised; of the last image, where that is found out
  /// in finish(). Nothing: it was not, or there is none.
  [[nodiscard]] std::optional<double> recognisedAt_s() const { return recognisedAt_s_; }

  /// Must outlive this object.
  void addObserver(FrameObserver& observer) { observers_.push_back(&observer); }

  /// All options in effect, as commented YAML that readSlamOptions() takes.
  [[nodiscard]] std::string configuration() const;

  [[nodiscard]] const core::LabelSpace& labelSpace() const { return frontEnd_.labelSpace(); }
  [[nodiscard]] const mapping::Zones& zones() const { return zones_; }
  [[nodiscard]] const core::Profiler& profiler() const { return frontEnd_.profiler(); }

 private:
  struct LastPose {
    std::uint32_t piece = 0;
    double stamp_s = 0.0;
  };

  void insert(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  void tell(odometry::MapUpdate update);
  SharedUpdates takeOverUpdates();
  void noteRecognition(std::uint32_t piece, double stamp_s);
  [[nodiscard]] static std::map<odometry::KeyframeId, Eigen::Isometry3d> posesIn(const graph::Mapper& mapper,
                                                                                 std::uint32_t piece);
  void finishGraph();

  SlamOptions options_;
  FrontEnd frontEnd_;
  mapping::Zones zones_;
  const bool canWait_;  ///< Images of a recording can.
  bool hasEarlierMap_ = false;
  std::optional<double> recognisedAt_s_;
  odometry::Pieces pieces_;
  std::optional<LastPose> last_;
  TrajectoryRecorder trajectory_;
  std::vector<FrameObserver*> observers_;

  core::Mailbox<std::shared_ptr<const odometry::MapUpdate>> mapUpdates_;  ///< By the stage that follows.
  SharedUpdates takenOver_;                                               ///< By tracking, since the last keyframe.
  core::Stage<graph::Mapper> graphBuilding_;
  std::unique_ptr<core::Stage<mapping::MapBuilder>> mapBuilding_;  ///< Null where there is no semantic map.
  std::unique_ptr<MapFeed> mapFeed_;                               ///< Null where there is no semantic map.
  std::unique_ptr<graph::Mapper> mapper_;                          ///< Once its stage is finished.
  std::unique_ptr<mapping::MapBuilder> mapBuilder_;                ///< Once its stage is finished.
};

}  // namespace wardslam::pipeline
