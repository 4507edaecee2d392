#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/stamp_clock.h"
#include "wardslam/core/trajectory.h"

/// Trajectories as text in the format of the TUM RGB-D benchmark: one pose per line,
/// `timestamp tx ty tz qx qy qz qw` (UNIX s, m, unit quaternion), lines starting with '#' are comments.
namespace wardslam::exchange {

/// How a trajectory is to be taken.
struct TrajectoryReading {
  std::function<void(const std::string&)> note = [](const std::string&) {};  ///< Hears what had to be assumed.
  /// Of stamps that number images; without, such numbers are the stamps.
  std::optional<double> rate_hz = {};
};

/// Reads what the benchmark's scripts accept: blanks, tabs or commas between the numbers; lines with NaN and zero
/// quaternions hold no pose and are skipped; quaternions are normalised; of two lines with one stamp the later counts.
/// So it does with what docs/inputs.md lists of other programs: other orders, told by a line of headings, a number of
/// the pose as ninth column, KITTI's matrices, stamps in ms, µs, ns, decimal commas. The result is in order of time,
/// never empty. Throws InputError naming file and line.
[[nodiscard]] core::Trajectory readTumTrajectory(const std::filesystem::path& file,
                                                 const TrajectoryReading& reading = {});

/// Whether its stamps seem to number images (0, 1, 2, …) instead of telling the time.
[[nodiscard]] bool numbersImages(const std::filesystem::path& trajectory);

/// The stamps (first column, UNIX s) of any list of the benchmark (rgb.txt, depth.txt, a trajectory), in order of
/// time, never empty. Throws InputError naming file and line.
[[nodiscard]] std::vector<double> readTumStamps(const std::filesystem::path& file,
                                                const TrajectoryReading& reading = {});

/// Writes pose by pose, so that a run that is killed loses nothing: until finish() the lines are in "<file>.partial".
class TumTrajectoryWriter {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TumTrajectoryWriter(const std::filesystem::path& file);
  ~TumTrajectoryWriter();  ///< Finishes, if nobody did; then errors are lost.
  TumTrajectoryWriter(const TumTrajectoryWriter&) = delete;
  TumTrajectoryWriter& operator=(const TumTrajectoryWriter&) = delete;

  void write(const core::StampedPose& pose);
  void writeComment(const std::string& line);  ///< Readers skip it.

  /// Whether the disk did not take all poses; the next write() and finish() try again.
  [[nodiscard]] bool isBehind() const { return file_.isBehind(); }

  /// Gives the file its name. Throws InputError when the disk did not take all of it; may be tried again then.
  void finish();

 private:
  core::AtomicFile file_;
  bool finished_ = false;
};

}  // namespace wardslam::exchange
