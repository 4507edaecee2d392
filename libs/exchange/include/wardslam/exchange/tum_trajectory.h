#pragma once

#include <filesystem>
#include <vector>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/trajectory.h"

/// Trajectories as text in the format of the TUM RGB-D benchmark: one pose per line,
/// `timestamp tx ty tz qx qy qz qw` (UNIX s, m, unit quaternion), lines starting with '#' are comments.
namespace wardslam::exchange {

/// Reads what the benchmark's scripts accept: blanks, tabs or commas between the numbers; lines with NaN and zero
/// quaternions hold no pose and are skipped; quaternions are normalised; of two lines with one stamp the later counts.
/// The result is in order of time, never empty. Throws InputError naming file and line.
[[nodiscard]] core::Trajectory readTumTrajectory(const std::filesystem::path& file);

/// The stamps (first column, UNIX s) of any list of the benchmark (rgb.txt, depth.txt, a trajectory), in order of
/// time, never empty. Throws InputError naming file and line.
[[nodiscard]] std::vector<double> readTumStamps(const std::filesystem::path& file);

/// Writes pose by pose, so that a run that is killed loses nothing: until finish() the lines are in "<file>.partial".
class TumTrajectoryWriter {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TumTrajectoryWriter(const std::filesystem::path& file);
  ~TumTrajectoryWriter();  ///< Finishes, if nobody did; then errors are lost.
  TumTrajectoryWriter(const TumTrajectoryWriter&) = delete;
  TumTrajectoryWriter& operator=(const TumTrajectoryWriter&) = delete;

  void write(const core::StampedPose& pose);

  /// Whether the disk did not take all poses; the next write() and finish() try again.
  [[nodiscard]] bool isBehind() const { return file_.isBehind(); }

  /// Gives the file its name. Throws InputError when the disk did not take all of it; may be tried again then.
  void finish();

 private:
  core::AtomicFile file_;
  bool finished_ = false;
};

}  // namespace wardslam::exchange
