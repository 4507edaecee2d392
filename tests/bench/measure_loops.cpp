#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tracked_recording.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/sources/observation_source.h"

/// measure_loops RECORDING GROUNDTRUTH [CONFIG]: runs over a recording and compares the loops that were closed, and the
/// places that were come back to, with the true trajectory.
namespace wardslam {
namespace {

constexpr double kFalse_m = 0.5;      // a loop is false if it says the camera stood so far from where it did
constexpr double kRevisit_m = 1.0;    // a place is come back to: as near as this ...
constexpr double kRevisit_rad = 0.5;  // ... and looking the same way ...
constexpr double kAwayFor_s = 30.0;   // ... after so long
constexpr double kOneVisit_s = 10.0;  // keyframes so near in time are of one visit
constexpr double kRight_m = 0.3;      // a visit is tied to the earlier one: the map has them within this of the truth

using Keyframes = std::map<odometry::KeyframeId, graph::KeyframeNode>;

/// A place that was come back to, by the keyframes that say so.
struct Visit {
  double from_s = 0.0;
  double to_s = 0.0;
  double earlier_s = 0.0;  ///< When the place was seen first.
  bool isOfOnePiece = false;
  bool isTied = false;
};

void tellMissed(const char* what, const Visit& visit) {
  if (visit.isTied) return;
  std::printf("missed %s: %.1f to %.1f s, where it was at %.1f s, %s\n", what, visit.from_s, visit.to_s,
              visit.earlier_s, visit.isOfOnePiece ? "in one piece and off" : "in another piece");
}

struct Counts {
  std::size_t loops = 0;
  std::size_t falseLoops = 0;
  std::size_t visits = 0;      ///< Times an earlier place was come back to.
  std::size_t visitsTied = 0;  ///< Of these, the ones that the map has where they are.
  double worstLoop_m = 0.0;
  std::size_t meetings = 0;        ///< Stretches tracked without a gap that come to where an earlier one was.
  std::size_t meetingsJoined = 0;  ///< Of these, the ones the map has where they are.
};

/// Where tracking found itself again after it was lost.
struct Relocalisations {
  std::size_t all = 0;
  std::size_t wrong = 0;

  void add(const odometry::OdometryResult& result, const Eigen::Isometry3d* T_world_cam) {
    if (!result.hasPose() || T_world_cam == nullptr) {
      wasLost_ = true;
      return;
    }
    const bool isSamePiece = last_ && last_->first.piece == result.piece;
    if (wasLost_ && isSamePiece) {
      ++all;
      const Eigen::Isometry3d step = last_->first.T_map_cam.inverse() * result.T_map_cam;
      const Eigen::Isometry3d trueStep = last_->second.inverse() * *T_world_cam;
      if ((trueStep.inverse() * step).translation().norm() > kFalse_m) ++wrong;
    }
    wasLost_ = false;
    last_ = {result, *T_world_cam};
  }

 private:
  bool wasLost_ = false;
  std::optional<std::pair<odometry::OdometryResult, Eigen::Isometry3d>> last_;
};

/// Stretches of tracking, by their submaps, that meet an earlier one: are they one piece, and do they lie rightly?
void compareMeetings(const Keyframes& keyframes, const bench::Truth& truth, Counts& counts) {
  std::map<std::uint32_t, Visit> meetings;
  for (const auto& [id, node] : keyframes) {
    const auto* here = truth.at(node.keyframe->stamp_s);
    for (const auto& [older, olderNode] : keyframes) {
      if (older >= id || here == nullptr) break;
      const auto* there = truth.at(olderNode.keyframe->stamp_s);
      if (olderNode.keyframe->submap == node.keyframe->submap || there == nullptr) continue;
      const Eigen::Isometry3d step = there->inverse() * *here;
      const bool meets =
          step.translation().norm() < kRevisit_m && Eigen::AngleAxisd(step.linear()).angle() < kRevisit_rad;
      if (!meets) continue;
      const Eigen::Isometry3d inMap = olderNode.T_map_cam.inverse() * node.T_map_cam;
      const bool isRight = olderNode.submap == node.submap && (step.inverse() * inMap).translation().norm() < kRight_m;
      const double here_s = node.keyframe->stamp_s;
      Visit& meeting =
          meetings.try_emplace(node.keyframe->submap, Visit{here_s, 0, olderNode.keyframe->stamp_s, false, false})
              .first->second;
      meeting.to_s = here_s;
      meeting.isOfOnePiece = meeting.isOfOnePiece || olderNode.submap == node.submap;
      meeting.isTied = meeting.isTied || isRight;
    }
  }
  counts.meetings = meetings.size();
  for (const auto& [submap, meeting] : meetings) {
    counts.meetingsJoined += meeting.isTied ? 1U : 0U;
    tellMissed("meeting", meeting);
  }
}

/// What a keyframe says of the places that it comes back to; nothing: it is where nothing was for long.
std::optional<Visit> revisitOf(const Keyframes& keyframes, const bench::Truth& truth, const graph::KeyframeNode& node) {
  const auto* here = truth.at(node.keyframe->stamp_s);
  if (here == nullptr) return std::nullopt;
  std::optional<Visit> visit;
  const double here_s = node.keyframe->stamp_s;
  for (const auto& [older, olderNode] : keyframes) {
    const double there_s = olderNode.keyframe->stamp_s;
    if (older >= node.keyframe->id || there_s + kAwayFor_s > here_s) break;
    const auto* there = truth.at(there_s);
    if (there == nullptr) continue;
    const Eigen::Isometry3d step = there->inverse() * *here;
    if (step.translation().norm() > kRevisit_m || Eigen::AngleAxisd(step.linear()).angle() > kRevisit_rad) continue;
    if (!visit) visit = Visit{here_s, here_s, there_s, false, false};
    if (olderNode.submap != node.submap) continue;
    const Eigen::Isometry3d inMap = olderNode.T_map_cam.inverse() * node.T_map_cam;
    visit->isOfOnePiece = true;
    visit->isTied = visit->isTied || (step.inverse() * inMap).translation().norm() < kRight_m;
  }
  return visit;
}

void compareVisits(const Keyframes& keyframes, const bench::Truth& truth, Counts& counts) {
  std::optional<Visit> visit;
  const auto endVisit = [&] {
    if (!visit) return;
    ++counts.visits;
    counts.visitsTied += visit->isTied ? 1U : 0U;
    tellMissed("visit", *visit);
  };
  for (const auto& [id, node] : keyframes) {
    const auto here = revisitOf(keyframes, truth, node);
    if (!here) continue;
    if (!visit || here->from_s - visit->to_s > kOneVisit_s) {
      endVisit();
      visit = here;
    }
    visit->to_s = here->to_s;
    visit->isOfOnePiece = visit->isOfOnePiece || here->isOfOnePiece;
    visit->isTied = visit->isTied || here->isTied;
  }
  endVisit();
}

Counts compare(const graph::Mapper& mapper, const bench::Truth& truth) {
  Counts counts;
  const Keyframes& keyframes = mapper.graph().keyframes();
  const auto trueStep = [&](odometry::KeyframeId a, odometry::KeyframeId b) -> std::optional<Eigen::Isometry3d> {
    const auto* from = truth.at(keyframes.at(a).keyframe->stamp_s);
    const auto* to = truth.at(keyframes.at(b).keyframe->stamp_s);
    if (from == nullptr || to == nullptr) return std::nullopt;
    return from->inverse() * *to;
  };
  for (const graph::Loop& loop : mapper.loops()) {
    const auto step = trueStep(loop.older, loop.newer);
    if (!step) continue;
    ++counts.loops;
    const double off_m = (step->inverse() * loop.T_older_newer).translation().norm();
    counts.worstLoop_m = std::max(counts.worstLoop_m, off_m);
    if (off_m > kFalse_m) {
      ++counts.falseLoops;
      std::printf("false: %lu (%.1f s) is said to be at %lu (%.1f s), %.2f m off\n",
                  static_cast<unsigned long>(loop.newer), keyframes.at(loop.newer).keyframe->stamp_s,
                  static_cast<unsigned long>(loop.older), keyframes.at(loop.older).keyframe->stamp_s, off_m);
    }
  }
  compareVisits(keyframes, truth, counts);
  compareMeetings(keyframes, truth, counts);
  return counts;
}

void run(const std::string& recording, const std::string& truthFile, const std::string& config) {
  pipeline::SlamSystem slam(bench::trackingAlone(config));
  const auto source = sources::openSource(recording, {});
  std::size_t frames = 0;
  std::size_t tracked = 0;
  const bench::Truth truth(truthFile);
  Relocalisations relocalisations;
  while (const auto observation = source->next()) {
    ++frames;
    const auto result = slam.process(observation);
    relocalisations.add(result, truth.at(core::fromMrptTime(observation->timestamp)));
    tracked += result.hasPose() ? 1U : 0U;
  }
  slam.finish();
  const Counts counts = compare(slam.mapper(), truth);
  std::printf(
      "%s: %zu of %zu frames tracked, %zu keyframes, %zu pieces, %zu joined, %zu loops closed, %zu taken back; "
      "%zu of %zu loop edges false (worst %.2f m), %zu of %zu visits tied, %zu of %zu meetings of stretches joined; "
      "%zu of %zu relocalisations wrong\n",
      recording.c_str(), tracked, frames, slam.mapper().graph().keyframes().size(),
      slam.mapper().pieces().sizes().size(), slam.mapper().submapsJoined(), slam.mapper().loopsClosed(),
      slam.mapper().loopsTakenBack(), counts.falseLoops, counts.loops, counts.worstLoop_m, counts.visitsTied,
      counts.visits, counts.meetingsJoined, counts.meetings, relocalisations.wrong, relocalisations.all);
  exchange::TumTrajectoryWriter writer(recording + ".estimate.txt");
  for (const auto& pose : slam.trajectory()) writer.write(pose);
  writer.finish();
}

}  // namespace
}  // namespace wardslam

int main(int count, char** arguments) {
  return wardslam::bench::measure("measure_loops", count, arguments, wardslam::run);
}
