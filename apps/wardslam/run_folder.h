#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "dynamic_truth.h"
#include "live_run.h"
#include "picture_writer.h"
#include "wardslam/core/event_counts.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/pipeline/frame_observer.h"
#include "wardslam/pipeline/frame_table.h"
#include "wardslam/pipeline/load_table.h"
#include "wardslam/pipeline/run_statistics.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/pipeline/zone_watch.h"
#include "wardslam/sources/sensor_counts.h"

namespace wardslam::apps {

/// What summary.json is made from.
struct RunSummary {
  const pipeline::RunStatistics& statistics;
  const pipeline::ZoneWatch& zones;
  const core::EventCounts& damage;
  const pipeline::SlamSystem& slam;  ///< Finished.
  std::size_t failedMapWrites;       ///< Made up for later, unless the run says otherwise.
  const DynamicTruth* truth;         ///< Null: not compared.
  const LiveRun* live;               ///< Null: a recording.
  PictureOptions pictures;
  bool interrupted;
  bool deterministic;
  sources::SensorCounts sensors;  ///< Of a rawlog.
};

/// The results of a run on disk: trajectory_live.txt (poses as they were known at the time; grows with every frame; a
/// comment tells where another piece begins), trajectory.txt (the frames in the map, corrected by all that was learnt
/// later), trajectory_piece_N.txt (those of pieces that are not joined to it), frames.csv (a line for every frame as it
/// comes), load.csv (a line for every second: what the run takes of the computer), config.yaml and summary.json.
class RunFolder : public pipeline::FrameObserver {
 public:
  /// Makes the folder. `slam` outlives this object. Throws core::InputError when the folder cannot be written.
  RunFolder(const std::filesystem::path& folder, const pipeline::SlamSystem& slam);

  /// Before the first frame: stamps in the files are seconds since then (UNIX s).
  void setStampOrigin(double origin_s);

  void writeConfiguration(const std::string& yaml) const;
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;
  /// Writes every result, whatever becomes of the others; then throws core::InputError for the first that failed.
  void finish(const RunSummary& summary);

 private:
  std::filesystem::path folder_;
  exchange::TumTrajectoryWriter live_;
  pipeline::FrameTable frames_;
  pipeline::LoadTable load_;
  double stampOrigin_s_ = 0.0;
  std::optional<std::uint32_t> livePiece_;  ///< Of the last pose written.
  bool wasBehind_ = false;                  ///< The disk did not take all poses.
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace wardslam::apps
