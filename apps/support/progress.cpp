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
  if (!total_) return draw(done, "", std::nullopt);
  draw(done, "/" + std::to_string(*total_), static_cast<double>(done) / static_cast<double>(*total_));
}

void Progress::update(std::size_t done, double share) {
  draw(done, " (" + std::to_string(std::lround(100.0 * share)) + " %)", share);
}

void Progress::draw(std::size_t done, const std::string& ofAll, std::optional<double> share) {
  const auto now = Clock::now();
  const bool isLast = share && *share >= 1.0;
  if (!isTerminal_ || (drawn_ && !isLast && now - *drawn_ < std::chrono::milliseconds(200))) return;
  drawn_ = now;

  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = elapsed_s > 0.0 ? static_cast<double>(done) / elapsed_s : 0.0;
  std::ostringstream line;
  line << "\r\033[K" << unit_ << " " << done << ofAll << "  " << std::fixed << std::setprecision(1) << rate << " "
       << unit_ << "s/s";
  if (share && *share > 0.0 && *share <= 1.0 && elapsed_s > 0.0) {
    line << "  " << std::setprecision(0) << std::ceil(elapsed_s * (1.0 - *share) / *share) << " s left";
  }
  out_ << line.str() << std::flush;
}

bool standardErrorIsTerminal() { return isatty(STDERR_FILENO) != 0; }

}  // namespace wardslam::apps
