#include "self_test.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include "built_in_room.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;
constexpr int kImages = 16;
constexpr double kLargestError_m = 0.02;
constexpr std::size_t kFewestCloudPoints = 1000;

/// Gone with all that is in it when this object is.
class WorkFolder {
 public:
  explicit WorkFolder(const fs::path& parent) : path_(parent / ("wardslam-doctor-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Outcome {
  core::Trajectory trajectory;
  storage::MapFileInfo map;
  std::vector<std::string> problems;  ///< Of the map file.
};

Outcome runThroughTheRoom(const fs::path& mapFile) {
  pipeline::SlamOptions options;
  options.deterministic = true;
  std::optional<storage::MapFileWriter> writer;  // outlives the system that writes to it
  pipeline::SlamSystem slam(options, {}, pipeline::WhenBehind::Waits);
  writer.emplace(mapFile, storage::MapHeader{slam.labelSpace(), slam.configuration()});
  slam.writeTo(*writer);
  const BuiltInRoom room;
  for (int image = 0; image < kImages; ++image) slam.process(room.look(image));
  slam.finish();
  writer->finish(*slam.mapBuilder(), slam.mapper());
  const auto file = storage::MapFile::open(mapFile);
  return {slam.trajectory(), file.info(), file.check()};
}

core::Trajectory truth() {
  core::Trajectory poses;
  for (int image = 0; image < kImages; ++image) {
    poses.push_back({BuiltInRoom::stamp_s(image), BuiltInRoom::T_room_cam(image)});
  }
  return poses;
}

Finding judge(const Outcome& outcome, double elapsed_s) {
  const auto trouble = [](const std::string& text) { return Finding{Finding::Kind::Trouble, "self-test", text}; };
  if (outcome.trajectory.size() != static_cast<std::size_t>(kImages)) {
    return trouble("only " + std::to_string(outcome.trajectory.size()) + " of " + std::to_string(kImages) +
                   " images of the built-in room were tracked");
  }
  const double error_m = evaluation::absoluteTrajectoryError(truth(), outcome.trajectory).translation_m.max;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "poses in the built-in room are off by up to " << 1000.0 * error_m
       << " mm";
  if (!(error_m <= kLargestError_m)) return trouble(text.str());
  if (!outcome.problems.empty()) return trouble("the map file is damaged: " + outcome.problems.front());
  if (outcome.map.keyframes == 0 || outcome.map.cloudPoints < kFewestCloudPoints) {
    return trouble("the map of the built-in room holds " + std::to_string(outcome.map.keyframes) + " keyframes and " +
                   std::to_string(outcome.map.cloudPoints) + " points");
  }
  text << "; " << kImages << " images segmented, tracked, mapped and checked in " << elapsed_s << " s";
  return {Finding::Kind::Good, "self-test", text.str()};
}

}  // namespace

Finding testTheWholeProgram(const fs::path& folder) {
  using Clock = std::chrono::steady_clock;
  try {
    const WorkFolder work(folder);
    const auto start = Clock::now();
    const Outcome outcome = runThroughTheRoom(work.path() / "map.wardmap");
    return judge(outcome, std::chrono::duration<double>(Clock::now() - start).count());
  } catch (const std::exception& error) {
    return {Finding::Kind::Trouble, "self-test", error.what()};
  }
}

}  // namespace wardslam::apps
