#pragma once

namespace wardslam::apps {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM ask the program to finish cleanly; a second one ends it at once.
///
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

  [[nodiscard]] bool requested() const;
};

}  // namespace wardslam::apps
