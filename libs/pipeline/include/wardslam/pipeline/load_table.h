#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/profiler.h"
#include "wardslam/pipeline/frame_observer.h"
#include "wardslam/pipeline/slam_system.h"

namespace wardslam::pipeline {

/// What a stretch of a run took of the computer.
struct LoadRow {
  double stamp_s = 0.0;       ///< Of its last frame.
  std::size_t frames = 0;     ///< In this stretch.
  double frame_ms = 0.0;      ///< Per frame, from the observation to the pose.
  std::size_t keyframes = 0;  ///< In this stretch.
  double graph_ms = 0.0;      ///< Work on the graph, in this stretch.
  double mapping_ms = 0.0;    ///< Work on the map, in this stretch.
  double storage_ms = 0.0;    ///< Work on the map file, in this stretch.
  double apply_ms = 0.0;      ///< What tracking spent on taking over what the graph found out, in this stretch.
  std::size_t waiting = 0;    ///< SlamSystem::waiting(), at its end.
  double memory_mb = 0.0;     ///< Resident, at its end.
  std::size_t openFiles = 0;  ///< At its end.

  [[nodiscard]] double map_ms() const { return graph_ms + mapping_ms + storage_ms; }
};

/// A line of text (CSV) for every second of a run (by the stamps of its frames), written as the run goes: until
/// finish() the lines are in "<file>.partial". Shows what grows.
class LoadTable : public FrameObserver {
 public:
  /// `slam` is observed and outlives this object. Throws core::InputError when the file cannot be created.
  LoadTable(const std::filesystem::path& file, const SlamSystem& slam);

  /// Stamps are seconds since then (UNIX s).
  void setStampOrigin(double origin_s) { stampOrigin_s_ = origin_s; }

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// Gives the file its name. Throws core::InputError when the disk did not take all of it.
  void finish() { file_.commit(); }

 private:
  void writeRow(double stamp_s);

  const SlamSystem& slam_;
  core::AtomicFile file_;
  double stampOrigin_s_ = 0.0;
  std::optional<double> lastRow_s_;
  std::size_t frames_ = 0;  ///< Since the last line.
  std::size_t keyframes_ = 0;
  std::map<std::string, core::Profiler::Total> before_;  ///< At the last line.
};

/// Reads such a file, in the order it has. A last line that is cut off, as of a run that was killed, is left out.
/// Throws core::InputError naming file and line.
[[nodiscard]] std::vector<LoadRow> readLoadTable(const std::filesystem::path& file);

}  // namespace wardslam::pipeline
