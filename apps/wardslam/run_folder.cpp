#include "run_folder.h"

#include <sys/resource.h>

#include <mrpt/system/os.h>
#include <cmath>

#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <system_error>
#include <vector>

#include "object_list.h"
#include "support/told_at_once.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/first_failure.h"

namespace wardslam::apps {
namespace {

std::filesystem::path makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw core::InputError(folder.string() + ": cannot be made: " + error.message());
  return folder;
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

double peakMemory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

nlohmann::ordered_json stagesJson(const core::Profiler& profiler) {
  nlohmann::ordered_json stages;
  for (const auto& [step, statistics] : profiler.statistics()) {
    stages[step] = {{"calls", statistics.calls},
                    {"median_ms", rounded(statistics.median_ms, 3)},
                    {"p95_ms", rounded(statistics.p95_ms, 3)}};
  }
  return stages;
}

nlohmann::ordered_json maskAgeJson(const pipeline::MaskAge& age) {
  return {{"median_frames", age.median_frames},
          {"p95_frames", age.p95_frames},
          {"median_ms", age.median_ms},
          {"p95_ms", age.p95_ms}};
}

nlohmann::ordered_json zonesJson(const std::map<std::string, pipeline::ZoneStay>& stays) {
  auto zones = nlohmann::ordered_json::object();
  for (const auto& [name, stay] : stays) {
    zones[name.empty() ? "outside" : name] = {
        {"time_s", rounded(stay.time_s, 3)}, {"distance_m", rounded(stay.distance_m, 3)}, {"entries", stay.entries}};
  }
  return zones;
}

nlohmann::ordered_json toJson(const evaluation::DetectionScore& score) {
  return {{"precision", score.precision()},  // NaN becomes null
          {"recall", score.recall()},
          {"spared", score.spared()},
          {"true_positives", score.truePositives},
          {"false_positives", score.falsePositives},
          {"false_negatives", score.falseNegatives},
          {"true_negatives", score.trueNegatives}};
}

nlohmann::ordered_json toJson(const DynamicTruth& truth) {
  return {{"frames", truth.frames()}, {"pixels", toJson(truth.pixels())}, {"keypoints", toJson(truth.keypoints())}};
}

nlohmann::ordered_json toJson(const LiveRun& live, std::size_t processed) {
  const auto counts = live.counts();
  const auto latency = live.latency();
  return {{"frames_in", counts.received},
          {"frames_processed", processed},
          {"frames_skipped", counts.skipped},
          {"frames_unusable", counts.unusable},
          {"reconnects", counts.reconnects},
          {"latency", {{"median_ms", rounded(latency.median_ms, 1)}, {"p95_ms", rounded(latency.p95_ms, 1)}}}};
}

void writeTrajectory(const std::filesystem::path& file, const core::Trajectory& trajectory, double stampOrigin_s) {
  exchange::TumTrajectoryWriter writer(file);
  bool wasBridged = false;
  for (const auto& [stamp_s, T_map_cam, isBridged] : trajectory) {
    if (isBridged != wasBridged) writer.writeComment(isBridged ? "not seen, but on the way between:" : "seen again");
    wasBridged = isBridged;
    writer.write({stamp_s - stampOrigin_s, T_map_cam});
  }
  writer.finish();
}

/// An earlier run into the same folder may have left some.
void removeTrajectoriesOfPieces(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().rfind("trajectory_piece_", 0) == 0) old.push_back(entry.path());
  }
  for (const auto& file : old) std::filesystem::remove(file, ignored);
}

/// Trouble that was survived, and what did not get into the results.
core::EventCounts eventsOf(const RunSummary& summary) {
  core::EventCounts events = summary.statistics.events();
  core::accumulate(events, summary.slam.leftOut());
  if (summary.failedMapWrites > 0) events["storage.write_failed"] = summary.failedMapWrites;
  return events;
}

core::EventCounts damageOf(const RunSummary& summary) {
  core::EventCounts damage = summary.damage;
  const std::size_t unusable = summary.statistics.unusableFrames();
  if (unusable > 0) damage["sources.observation_unusable"] += unusable;
  return damage;
}

nlohmann::ordered_json versionsJson() {
  return {
      {"wardslam", WARDSLAM_VERSION}, {"MRPT", mrpt::system::MRPT_getVersion()}, {"OpenCV", cv::getVersionString()}};
}

nlohmann::ordered_json picturesJson(const PictureOptions& pictures) {
  return {{"interval", pictures.interval}, {"people_kept", pictures.keepsPeople}};
}

nlohmann::ordered_json floorJson(const mapping::FloorSeen& floor) {
  return {
      {"keyframes", floor.keyframes}, {"seen", floor.seen}, {"tilt_deg", rounded(floor.tilt_rad * 180.0 / M_PI, 2)}};
}

std::ptrdiff_t bridgedOf(const core::Trajectory& trajectory) {
  return std::count_if(trajectory.begin(), trajectory.end(), [](const auto& pose) { return pose.isBridged; });
}

nlohmann::ordered_json toJson(const RunSummary& summary, const core::Trajectory& trajectory, double elapsed_s) {
  const auto& statistics = summary.statistics;
  nlohmann::ordered_json json;
  json["frames"] = statistics.frames();
  json["frames_tracked"] = statistics.framesTracked();
  json["coverage"] = statistics.coverage();
  json["frames_bridged"] = bridgedOf(trajectory);
  json["lost_events"] = statistics.lostEvents();
  json["frames_held_by_depth"] = statistics.framesHeldByDepth();
  json["readout_ms"] = rounded(1e3 * statistics.readout_s(), 1);
  json["keyframes"] = statistics.keyframes();
  json["loops_closed"] = summary.slam.mapper().loopsClosed();
  json["submaps_joined"] = summary.slam.mapper().submapsJoined();
  json["pieces"] = summary.slam.mapper().pieces().sizes().size();
  json["pieces_unjoined"] = summary.slam.unjoinedTrajectories().size();
  json["dynamic_keypoint_fraction"] = statistics.dynamicKeypointFraction();
  if (summary.truth != nullptr) json["dynamic"] = toJson(*summary.truth);
  if (summary.live != nullptr) json["live"] = toJson(*summary.live, statistics.frames());
  if (summary.pictures.interval > 0) json["pictures"] = picturesJson(summary.pictures);
  json["mask_age"] = maskAgeJson(statistics.maskAge());
  if (!summary.slam.zones().all().empty()) json["zones"] = zonesJson(summary.zones.stays());
  if (summary.slam.mapBuilder() != nullptr) json["floor"] = floorJson(summary.slam.mapBuilder()->floorSeen());
  json["stages"] = stagesJson(summary.slam.profiler());
  json["fps"] = elapsed_s > 0 ? rounded(static_cast<double>(statistics.frames()) / elapsed_s, 2) : 0.0;
  json["peak_rss_mb"] = rounded(peakMemory_mb(), 1);
  json["versions"] = versionsJson();
  json["deterministic"] = summary.deterministic;
  json["interrupted"] = summary.interrupted;
  json["events"] = eventsOf(summary);
  json["damaged_input"] = damageOf(summary);
  if (summary.sensors.observations.size() > 1) {
    json["sensor"] = summary.sensors.taken;
    json["sensors"] = summary.sensors.observations;
  }
  return json;
}

}  // namespace

RunFolder::RunFolder(const std::filesystem::path& folder, const pipeline::SlamSystem& slam)
    : folder_(makeFolder(folder)),
      live_(folder / "trajectory_live.txt"),
      frames_(folder / "frames.csv"),
      load_(folder / "load.csv", slam) {}

void RunFolder::setStampOrigin(double origin_s) {
  stampOrigin_s_ = origin_s;
  frames_.setStampOrigin(origin_s);
  load_.setStampOrigin(origin_s);
}

void RunFolder::writeConfiguration(const std::string& yaml) const {
  core::writeFileAtomically(folder_ / "config.yaml", yaml);
}

void RunFolder::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  frames_.onFrame(frame, odometry);
  load_.onFrame(frame, odometry);
  if (!odometry.hasPose()) return;
  if (livePiece_ && *livePiece_ != odometry.piece) live_.writeComment("piece " + std::to_string(odometry.piece));
  livePiece_ = odometry.piece;
  live_.write({frame.stamp_s - stampOrigin_s_, odometry.T_map_cam});
  const bool isBehind = live_.isBehind();
  if (isBehind && !wasBehind_) {
    tellAtOnce((folder_ / "trajectory_live.txt").string() +
               ": cannot be written (is the disk full?); the poses are kept and it is tried again with each");
  }
  wasBehind_ = isBehind;
}

void RunFolder::finish(const RunSummary& summary) {
  core::FirstFailure failure;
  failure.attempt([&] { live_.finish(); });
  failure.attempt([&] { frames_.finish(); });
  failure.attempt([&] { load_.finish(); });
  failure.attempt([&] { removeTrajectoriesOfPieces(folder_); });
  core::Trajectory inMap;
  failure.attempt([&] {
    inMap = summary.slam.trajectory();
    writeTrajectory(folder_ / "trajectory.txt", inMap, stampOrigin_s_);
  });
  failure.attempt([&] {
    for (const auto& [piece, trajectory] : summary.slam.unjoinedTrajectories()) {
      writeTrajectory(folder_ / ("trajectory_piece_" + std::to_string(piece) + ".txt"), trajectory, stampOrigin_s_);
    }
  });
  failure.attempt([&] {
    if (summary.slam.buildsSemanticMap()) writeObjects(folder_ / "objects.json", summary.slam.semanticMap());
  });
  failure.attempt([&] {
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    core::writeFileAtomically(folder_ / "summary.json", toJson(summary, inMap, elapsed_s).dump(2) + "\n");
  });
  failure.rethrow();
}

}  // namespace wardslam::apps
