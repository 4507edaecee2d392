#include "run_record.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <iterator>
#include <system_error>

#include "wardslam/building/rooms_of_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/mapping/floor_planner.h"
#include "wardslam/report/run_report.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::report {
namespace {

namespace fs = std::filesystem;

fs::path partial(const fs::path& file) { return file.string() + ".partial"; }

/// Results of an earlier run into the same folder lie beside what one writes that has not ended.
bool isUnfinished(const fs::path& folder) { return fs::exists(partial(folder / "trajectory_live.txt")); }

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void requireRun(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw core::InputError(folder.string() + ": no such folder; give the one that `wardslam run` wrote (--out)");
  }
  for (const char* file : {"summary.json", "trajectory.txt", "trajectory_live.txt.partial", "config.yaml"}) {
    if (fs::exists(folder / file)) return;
  }
  throw core::InputError(folder.string() +
                         ": holds nothing of a run; give the folder that `wardslam run` wrote (--out)");
}

class Reader {
 public:
  Reader(fs::path folder, fs::path map) : folder_(std::move(folder)), map_(std::move(map)) {}

  RunRecord read() {
    record_.isFinished = !isUnfinished(folder_);
    readSummary();
    readConfiguration();
    readTrajectory();
    readFrames();
    readLoad();
    readMap();
    listFolder();
    return std::move(record_);
  }

 private:
  void lack(const std::string& sentence) { record_.missing.push_back(sentence); }

  /// What fails costs its part of the report, and a sentence.
  void attempt(const std::function<void()>& work) {
    try {
      work();
    } catch (const std::exception& error) {
      lack(withoutFolder(error.what()));
    }
  }

  /// A report is passed on; where it was made is nobody's business.
  [[nodiscard]] std::string withoutFolder(std::string sentence) const {
    const std::string folder = (folder_ / "").string();
    for (auto at = sentence.find(folder); at != std::string::npos; at = sentence.find(folder)) {
      sentence.erase(at, folder.size());
    }
    return sentence;
  }

  void readSummary() {
    record_.summary = nlohmann::ordered_json::object();
    if (!record_.isFinished) {
      lack("The run was killed or still goes on: there is no summary, and poses are as they were known at the time.");
      return;
    }
    const fs::path file = folder_ / "summary.json";
    if (!fs::exists(file)) {
      lack("summary.json is not there: figures and stage times are missing.");
      return;
    }
    auto json = nlohmann::ordered_json::parse(textOf(file), nullptr, /*allow_exceptions=*/false);
    if (json.is_object()) {
      record_.summary = std::move(json);
      const auto interrupted = record_.summary.find("interrupted");
      if (interrupted != record_.summary.end() && *interrupted == true) lack("The run was interrupted before its end.");
    } else {
      lack("summary.json is damaged: figures and stage times are missing.");
    }
  }

  void readConfiguration() {
    record_.configuration = textOf(folder_ / "config.yaml");
    if (record_.configuration.empty()) lack("config.yaml is not there: the configuration is not known.");
  }

  void readTrajectory() {
    const fs::path file = trajectoryOf(folder_);
    if (!fs::exists(file)) {
      lack(file.filename().string() + " is not there: there is no way to draw.");
      return;
    }
    attempt([&] { record_.trajectory = exchange::readTumTrajectory(file); });
  }

  void readFrames() {
    fs::path file = folder_ / "frames.csv";
    if (!record_.isFinished) file = partial(file);
    if (!fs::exists(file)) {
      lack(file.filename().string() + " is not there: key points and lost stretches are not known frame by frame.");
      return;
    }
    attempt([&] { record_.frames = pipeline::readFrameTable(file); });
    std::stable_sort(record_.frames.begin(), record_.frames.end(),
                     [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  }

  void readLoad() {
    fs::path file = folder_ / "load.csv";
    if (!record_.isFinished) file = partial(file);
    if (!fs::exists(file)) {
      lack(file.filename().string() + " is not there: what the run took of the computer is not known.");
      return;
    }
    attempt([&] { record_.load = pipeline::readLoadTable(file); });
    std::stable_sort(record_.load.begin(), record_.load.end(),
                     [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  }

  void readMap() {
    const fs::path file = map_.empty() ? folder_ / "map.wardmap" : map_;
    if (!fs::exists(file)) {
      lack(file.filename().string() +
           " is not there: floor, rooms, zones and things are missing; a map that lies elsewhere is named with --map.");
      return;
    }
    attempt([&] {
      record_.map = storage::MapFile::open(file).read();
      auto& map = *record_.map;
      if (map.floorPlan.cells.empty() && !map.keyframes.empty()) map.floorPlan = mapping::drawFloorPlan(map, {});
      record_.rooms = building::roomsOf(map);
    });
  }

  void listFolder() {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder_ / "pictures", ignored)) {
      if (entry.path().extension() == ".jpg") record_.pictures.push_back(entry.path());
    }
    const auto stamp = [](const fs::path& file) { return std::strtod(file.stem().c_str(), nullptr); };
    std::sort(record_.pictures.begin(), record_.pictures.end(),
              [&](const fs::path& a, const fs::path& b) { return std::pair(stamp(a), a) < std::pair(stamp(b), b); });
    for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
      if (entry.path().filename().string().rfind("trajectory_piece_", 0) == 0) ++record_.unjoinedPieces;
    }
  }

  fs::path folder_;
  fs::path map_;
  RunRecord record_;
};

}  // namespace

double RunRecord::start_s() const {
  if (!frames.empty()) return frames.front().stamp_s;
  return trajectory.empty() ? 0.0 : trajectory.front().stamp_s;
}

double RunRecord::end_s() const {
  if (!frames.empty()) return frames.back().stamp_s;
  return trajectory.empty() ? 0.0 : trajectory.back().stamp_s;
}

fs::path trajectoryOf(const fs::path& runFolder) {
  return isUnfinished(runFolder) ? partial(runFolder / "trajectory_live.txt") : runFolder / "trajectory.txt";
}

RunRecord readRun(const fs::path& folder, const fs::path& map) {
  requireRun(folder);
  return Reader(folder, map).read();
}

}  // namespace wardslam::report
