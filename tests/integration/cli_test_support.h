#pragma once

#include <string>
#include <vector>

namespace wardslam::test {

/// What a program left behind.
struct CommandResult {
  int exitCode = 0;  ///< 128 + signal where a signal ended it.
  std::string out;   ///< Standard output.
  std::string err;   ///< Standard error.
};

/// Runs one of our programs ("wardslam") to its end, without a shell. Throws std::runtime_error when it cannot be
/// started.
[[nodiscard]] CommandResult runProgram(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace wardslam::test
