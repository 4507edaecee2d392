#pragma once

#include <mrpt/obs/CObservation.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "wardslam/core/mrpt_slam_compat.h"
#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/mrpt_slam/map_builder_options.h"

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::mrpt_slam {

class Session;

/// WardSLAM (a pipeline::SlamSystem) behind the interface of MRPT's SLAM programs: what drives a CMetricMapBuilderICP
/// or a CMetricMapBuilderRBPF drives this one by changing the line that names the class.
///
///     CMetricMapBuilderSemantic builder;                       // in place of mrpt::slam::CMetricMapBuilderICP
///     builder.loadFromConfigFile(ini, "MappingApplication");   // readMapBuilderConfiguration()
///     builder.initialize();
///     builder.processActionObservation(action, observations);  // or processObservation()
///     builder.finish();                                        // ours alone: the last adjustment of the whole map
///
/// Every function locks the critical section of the base class, so all may be called by several threads. What cannot
/// be used is a core::InputError (set-up) or a core::FrameError (one image: leave it out and go on), both
/// std::runtime_error.
///
/// `options.enableMapUpdating` counts when initialize() is called: false finds the robot in the map of the options and
/// leaves that as it is. `options.debugForceInsertion` and `alwaysInsertByClass` mean nothing here: which images become
/// keyframes is up to tracking.
class CMetricMapBuilderSemantic : public mrpt::slam::CMetricMapBuilder {
 public:
  CMetricMapBuilderSemantic();
  ~CMetricMapBuilderSemantic() override;

  /// What counts at the next initialize().
  MapBuilderConfiguration configuration;

  /// Reads it: readMapBuilderConfiguration().
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& ini, const std::string& section = "MappingApplication",
                          const std::vector<std::string>& ofTheProgram = {});

  /// Begins anew, in the .wardmap of the configuration if it names one; the robot stands at the mean of `x0` (null: the
  /// origin) on the floor. A simple map that holds something goes before that .wardmap: it is looked at once more
  /// (makeMapFile(), which takes as long as a run over its keyframes and says what their scans must have), and then
  /// gone on in as in a .wardmap, see below. Throws core::InputError for one that cannot be used.
  void initialize(const mrpt::maps::CSimpleMap& initialMap = mrpt::maps::CSimpleMap(),
                  const mrpt::poses::CPosePDF* x0 = nullptr) override;

  /// The same, going on in this map: the camera may start anywhere in it, and the pose is in a frame of its own until a
  /// place is recognised.
  void initialize(const std::filesystem::path& wardmap);

  /// `action`: how the robot moved since the call before, by its wheels; where it says nothing, tracking takes it to
  /// move on as it did. Of `observations` the RGB-D scan is tracked, and all is kept with the keyframes. Without an
  /// initialize() before, that is done first.
  void processActionObservation(mrpt::obs::CActionCollection& action, mrpt::obs::CSensoryFrame& observations) override;

  /// A single observation: an RGB-D scan, or a reading of the odometer (CObservationOdometry) before the scan that it
  /// moves; all else is kept with the next keyframe. Null is passed over.
  void processObservation(const mrpt::obs::CObservation::Ptr& observation);

  /// Of the robot's base in the map frame, as CPose3DPDFGaussian: how sure the last image is of it within the map
  /// around the camera, with the action's own covariance. That the map itself drifts is not in it. While tracking is
  /// lost: where actions lead, whose covariances add up; without actions, where the robot was last, and as unsure as it
  /// can have gone by now (`odometry.relocalisation`). Before the first image: where it starts, without covariance.
  mrpt::poses::CPose3DPDF::Ptr getCurrentPoseEstimation() const override;

  /// The keyframes of the map as they stand now, in order: the pose of the robot's base (standard deviation
  /// exchange::kKeyframePoseSigma) and what was observed there: of the RGB-D scan the points that do not move, its
  /// colour image as a file if MapBuilderOptions::images says so, and the other observations. Keyframes of an earlier
  /// map are as exchange::toSimpleMap() has them. Waits for the map.
  void getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const override;

  /// Keyframes by now, without waiting: those not yet worked in, and of pieces not yet joined to the map, included.
  unsigned int getCurrentlyBuiltMapSize() override;

  /// The maps that the configuration asks for, by default a CSemanticMap. Waits for the map, and is made anew when
  /// frames came since. Valid until the next call of this function or of initialize().
  core::BuiltMetricMap getCurrentlyBuiltMetricMap() const override;

  /// The floor plan with the way and the robot. `file` ends in .png or .bmp, else .png is added; there is no EMF.
  void saveCurrentEstimationToImage(const std::string& file, bool formatEMF_BMP = true) override;

  /// After the last observation, and where it must be exact: adjusts the whole map once more. What is asked after it is
  /// of the end; to go on needs an initialize().
  void finish();

  /// The camera's, for every frame in the map, by the map as it is now. Waits for the map.
  [[nodiscard]] core::Trajectory trajectory() const;

  /// The semantic map as plain data. Waits for the map.
  [[nodiscard]] mapping::SemanticMap semanticMap() const;

 private:
  template <class Do>
  decltype(auto) locked(const Do& work) const;
  void begin(const mrpt::maps::CSimpleMap& simple, const mrpt::poses::CPosePDF* x0);
  Session& begun();
  void warnOfLateChange();

  std::unique_ptr<Session> session_;
  bool updatesTheMap_ = true;  ///< What enableMapUpdating was when the session began.
  bool saidThatItIsLate_ = false;
};

}  // namespace wardslam::mrpt_slam
