#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

namespace wardslam::apps {

/// One line that tells how far long work is: "frame 120/300  31.2 fps  6 s left". Redrawn at most five times a second;
/// says nothing unless `out` is a terminal.
class Progress {
 public:
  /// `total`: items to come, where known. `unit`: "frame".
  Progress(std::ostream& out, bool isTerminal, std::string unit, std::optional<std::size_t> total);
  ~Progress();  ///< Ends the line.
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done);

  /// Where only the share of all work is known that is done (0..1): "frame 120 (40 %)  31.2 frames/s  6 s left".
  void update(std::size_t done, double share);

 private:
  using Clock = std::chrono::steady_clock;

  void draw(std::size_t done, const std::string& ofAll, std::optional<double> share);

  std::ostream& out_;
  bool isTerminal_;
  std::string unit_;
  std::optional<std::size_t> total_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> drawn_;
};

/// Whether standard error is a terminal.
[[nodiscard]] bool standardErrorIsTerminal();

}  // namespace wardslam::apps
