#include "models/transfer_progress.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace wardslam::apps {

std::string sizeText(std::uint64_t bytes) {
  constexpr const char* kUnits[] = {"B", "kB", "MB", "GB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 999.95 && unit < 3) {
    value /= 1000.0;
    ++unit;
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(unit == 0 ? 0 : 1) << value << " " << kUnits[unit];
  return text.str();
}

std::string transferText(const DownloadState& state, double elapsed_s) {
  std::string text = sizeText(state.done_bytes);
  if (state.total_bytes) text += " of " + sizeText(*state.total_bytes);
  const auto transferred = static_cast<double>(state.done_bytes - state.resumedFrom_bytes);
  if (elapsed_s <= 0.0 || transferred <= 0.0) return text;
  const double rate = transferred / elapsed_s;
  text += "  " + sizeText(static_cast<std::uint64_t>(rate)) + "/s";
  if (state.total_bytes && *state.total_bytes >= state.done_bytes) {
    const double left_s = std::ceil(static_cast<double>(*state.total_bytes - state.done_bytes) / rate);
    text += "  " + std::to_string(static_cast<long>(left_s)) + " s left";
  }
  return text;
}

TransferProgress::TransferProgress(std::ostream& out, bool isTerminal, std::string name)
    : out_(out), isTerminal_(isTerminal), name_(std::move(name)) {}

TransferProgress::~TransferProgress() {
  if (drawn_) out_ << "\n" << std::flush;
}

void TransferProgress::update(const DownloadState& state) {
  const auto now = Clock::now();
  const bool isLast = state.total_bytes && state.done_bytes >= *state.total_bytes;
  if (!isTerminal_ || (drawn_ && !isLast && now - *drawn_ < std::chrono::milliseconds(200))) return;
  drawn_ = now;
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  out_ << "\r\033[K" << name_ << "  " << transferText(state, elapsed_s) << std::flush;
}

}  // namespace wardslam::apps
