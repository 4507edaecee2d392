#include "support/progress.h"

#include <unistd.h>

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace wardslam::apps {

Progress::Progress(std::ostream& out, bool isTerminal, std::string unit, std::optional<std::size_t> total)
    : out_(out), isTerminal_(isTerminal), unit_(std::move(unit)), total_(total) {}

Progress::~Progress() {
  if (drawn_) out_ << "\n" << std::flush;
}

void Progress::update(std::size_t done) {
  const auto now = Clock::now();
  const bool isLast = total_ && done >= *total_;
  if (!isTerminal_ || (drawn_ && !isLast && now - *drawn_ < std::chrono::milliseconds(200))) return;
  drawn_ = now;

  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = elapsed_s > 0.0 ? static_cast<double>(done) / elapsed_s : 0.0;
  std::ostringstream line;
  line << "\r\033[K" << unit_ << " " << done;
  if (total_) line << "/" << *total_;
  line << "  " << std::fixed << std::setprecision(1) << rate << " " << unit_ << "s/s";
  if (total_ && rate > 0.0 && done <= *total_) {
    line << "  " << std::setprecision(0) << std::ceil(static_cast<double>(*total_ - done) / rate) << " s left";
  }
  out_ << line.str() << std::flush;
}

bool standardErrorIsTerminal() { return isatty(STDERR_FILENO) != 0; }

}  // namespace wardslam::apps
