#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace wardslam::test {

/// What a program left behind.
struct CommandResult {
  int exitCode = 0;  ///< 128 + signal where a signal ended it.
  std::string out;   ///< Standard output.
  std::string err;   ///< Standard error.
};

/// One of our programs ("wardslam") at work, started without a shell.
class RunningProgram {
 public:
  /// Throws std::runtime_error when it cannot be started.
  RunningProgram(const std::string& program, const std::vector<std::string>& arguments);
  ~RunningProgram();  ///< Kills it unless waited for.
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  void send(int signal) const;

  /// From now on no file of it can grow beyond so many bytes, as if the disk were full; without a number, it can.
  void limitFiles(std::optional<std::uint64_t> bytes) const;

  /// To its end.
  [[nodiscard]] CommandResult wait();

 private:
  TemporaryFolder folder_;
  pid_t pid_ = 0;
};

/// Runs one of our programs ("wardslam") to its end, without a shell. Throws std::runtime_error when it cannot be
/// started.
[[nodiscard]] CommandResult runProgram(const std::string& program, const std::vector<std::string>& arguments);

/// All that so many runs say of recordings that show no floor, as those of RoomRecording.
inline std::string noFloorIsSeen(int runs = 1) {
  std::string text;
  for (int i = 0; i < runs; ++i) {
    text += "wardslam: no image shows the floor: the floor plan takes it to be at z = 0 of the map frame\n";
  }
  return text;
}

}  // namespace wardslam::test
