#pragma once

#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>

#include "models/download.h"

namespace wardslam::apps {

/// "6.2 MB", decimal units.
[[nodiscard]] std::string sizeText(std::uint64_t bytes);

/// "12.0 MB of 62.0 MB  2.5 MB/s  20 s left"; the rate counts what was transferred since the start, not what an earlier
/// download left.
[[nodiscard]] std::string transferText(const DownloadState& state, double elapsed_s);

/// One line that tells how far a download is, redrawn at most five times a second; says nothing unless `out` is a
/// terminal.
class TransferProgress {
 public:
  TransferProgress(std::ostream& out, bool isTerminal, std::string name);
  ~TransferProgress();  ///< Ends the line.
  TransferProgress(const TransferProgress&) = delete;
  TransferProgress& operator=(const TransferProgress&) = delete;

  void update(const DownloadState& state);

 private:
  using Clock = std::chrono::steady_clock;
  std::ostream& out_;
  bool isTerminal_;
  std::string name_;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> drawn_;
};

}  // namespace wardslam::apps
