#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/interruption.h"

namespace wardslam::apps {

/// How a program ended.
struct EndedProcess {
  pid_t process = 0;
  int exitCode = 0;  ///< 128 + signal where a signal ended it.
};

/// Programs at work beside this one, which end with it, however it ends.
class ChildProcesses {
 public:
  ChildProcesses() = default;
  ~ChildProcesses();  ///< Asks those that are left to end, and waits for them.
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  /// Standard output and standard error go to files. Throws core::InputError when there can be no further process.
  pid_t start(const std::string& program, const std::vector<std::string>& arguments, const std::filesystem::path& out,
              const std::filesystem::path& err);

  /// One that has ended meanwhile.
  [[nodiscard]] std::optional<EndedProcess> reap();

  [[nodiscard]] std::size_t running() const { return processes_.size(); }

  /// SIGTERM to all.
  void askToEnd() const;

 private:
  std::vector<pid_t> processes_;
};

/// To its end, or until it has ended because it was asked to, on an interruption. Exit code as of EndedProcess.
[[nodiscard]] int runToEnd(const std::string& program, const std::vector<std::string>& arguments,
                           const std::filesystem::path& out, const std::filesystem::path& err,
                           const InterruptionGuard& interruption);

/// The last line of a file, "" where there is none: what our programs say when they fail is one sentence, the last.
[[nodiscard]] std::string lastLine(const std::filesystem::path& file);

/// This program, by its full path.
[[nodiscard]] std::string thisProgram();

/// How many cores this process may use.
[[nodiscard]] int usableCores();

}  // namespace wardslam::apps
