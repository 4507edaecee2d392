#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace wardslam::sources {

/// A program that grabs from a sensor and writes SensorMessages to its standard output. Closing its standard input asks
/// it to end. What a driver may do – wait for ever, crash, leave threads behind – stays in that process.
class SensorProcess {
 public:
  /// Starts `command` (program and arguments). Throws core::InputError when it cannot be started.
  explicit SensorProcess(const std::vector<std::string>& command);

  /// Asks the program to end and kills it when it does not.
  ~SensorProcess();
  SensorProcess(const SensorProcess&) = delete;
  SensorProcess& operator=(const SensorProcess&) = delete;

  [[nodiscard]] int output() const { return output_; }  ///< To read messages from.

  /// Without asking: for a driver that hangs.
  void kill();

  /// After the output was closed: how the program ended, as the end of a sentence ("ended with signal 11 …").
  [[nodiscard]] std::string howItEnded();

 private:
  [[nodiscard]] bool hasEnded(std::chrono::milliseconds patience);

  int input_ = -1;
  int output_ = -1;
  pid_t pid_ = 0;  ///< 0: ended and waited for.
  int status_ = 0;
};

}  // namespace wardslam::sources
