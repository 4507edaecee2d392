#include "wardslam/pipeline/load_table.h"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <system_error>

#include "table_text.h"

namespace wardslam::pipeline {
namespace {

constexpr const char* kHeadings =
    "timestamp,frames,frame_ms,keyframes,graph_ms,mapping_ms,storage_ms,apply_ms,waiting,memory_mb,open_files";
constexpr std::size_t kColumns = 11;
constexpr double kPeriod_s = 1.0;
const std::string kFrameStep = "pipeline.process";
const std::string kApplyStep = "odometry.apply";

/// Of Linux; 0 where it does not tell.
double residentMemory_mb() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total_pages = 0;
  std::size_t resident_pages = 0;
  statm >> total_pages >> resident_pages;
  return static_cast<double>(resident_pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

/// Of Linux; 0 where it does not tell. The one that looks is none.
std::size_t openFiles() {
  std::error_code unknown;
  std::size_t count = 0;
  for (auto entry = std::filesystem::directory_iterator("/proc/self/fd", unknown);
       entry != std::filesystem::directory_iterator(); entry.increment(unknown)) {
    ++count;
  }
  return count > 0 ? count - 1 : 0;
}

std::optional<LoadRow> rowOf(const std::string& line) {
  const auto words = core::wordsIn(line);
  LoadRow row;
  const bool isRow = words.size() == kColumns && readWord(words[0], row.stamp_s) && std::isfinite(row.stamp_s) &&
                     readWord(words[1], row.frames) && readWord(words[2], row.frame_ms) &&
                     readWord(words[3], row.keyframes) && readWord(words[4], row.graph_ms) &&
                     readWord(words[5], row.mapping_ms) && readWord(words[6], row.storage_ms) &&
                     readWord(words[7], row.apply_ms) && readWord(words[8], row.waiting) &&
                     readWord(words[9], row.memory_mb) && readWord(words[10], row.openFiles);
  return isRow ? std::optional(row) : std::nullopt;
}

}  // namespace

LoadTable::LoadTable(const std::filesystem::path& file, const SlamSystem& slam) : slam_(slam), file_(file) {
  file_.stream() << kHeadings << '\n' << std::fixed << std::flush;
}

void LoadTable::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  ++frames_;
  keyframes_ += odometry.keyframe ? 1 : 0;
  if (!lastRow_s_) lastRow_s_ = frame.stamp_s;
  if (frame.stamp_s - *lastRow_s_ < kPeriod_s) return;
  writeRow(frame.stamp_s);
  lastRow_s_ = frame.stamp_s;
  frames_ = 0;
  keyframes_ = 0;
}

void LoadTable::writeRow(double stamp_s) {
  const auto now = slam_.profiler().totals();
  const auto since = [&](const std::string& step) {
    const auto is = now.find(step);
    if (is == now.end()) return core::Profiler::Total{};
    const auto was = before_[step];
    return core::Profiler::Total{is->second.calls - was.calls, is->second.total_ms - was.total_ms};
  };
  const auto ofRoom_ms = [&](const std::string& prefix) {
    double sum_ms = 0.0;
    for (const auto& [step, total] : now) sum_ms += step.rfind(prefix, 0) == 0 ? since(step).total_ms : 0.0;
    return sum_ms;
  };
  const auto process = since(kFrameStep);  // of the frames until the one before: this one is not done yet
  const double frame_ms = process.calls > 0 ? process.total_ms / static_cast<double>(process.calls) : 0.0;
  file_.stream() << std::setprecision(6) << stamp_s - stampOrigin_s_ << ',' << frames_ << ',' << std::setprecision(2)
                 << frame_ms << ',' << keyframes_ << ',' << ofRoom_ms("graph.") << ',' << ofRoom_ms("mapping.") << ','
                 << ofRoom_ms("storage.") << ',' << since(kApplyStep).total_ms << ',' << slam_.waiting() << ','
                 << residentMemory_mb() << ',' << openFiles() << '\n'
                 << std::flush;
  before_ = now;
}

std::vector<LoadRow> readLoadTable(const std::filesystem::path& file) { return readTable(file, kHeadings, rowOf); }

}  // namespace wardslam::pipeline
