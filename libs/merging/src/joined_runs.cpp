#include "joined_runs.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>

namespace wardslam::merging {
namespace {

/// By keyframe: the runs are one after the other.
std::size_t runOf(const std::vector<Run>& runs, graph::KeyframeId id) {
  const auto isBehind = [id](const Run& run) { return run.map.graph.keyframes.back()->id < id; };
  return static_cast<std::size_t>(std::find_if_not(runs.begin(), runs.end(), isBehind) - runs.begin());
}

/// Of the first so many.
std::size_t keyframesOf(const std::vector<Run>& runs, std::size_t count) {
  std::size_t keyframes = 0;
  for (std::size_t i = 0; i < count; ++i) keyframes += runs[i].map.graph.keyframes.size();
  return keyframes;
}

/// Of two alike the older one.
std::uint32_t largestOf(const odometry::Pieces& pieces) {
  const auto& sizes = pieces.sizes();
  const auto isSmaller = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(sizes.begin(), sizes.end(), isSmaller)->first;
}

/// The index of places is made with OpenCV's random numbers, which have to be the same each time.
class OwnRandomNumbers {
 public:
  OwnRandomNumbers() { cv::theRNG() = cv::RNG(); }
  ~OwnRandomNumbers() { cv::theRNG() = before_; }
  OwnRandomNumbers(const OwnRandomNumbers&) = delete;
  OwnRandomNumbers& operator=(const OwnRandomNumbers&) = delete;

 private:
  cv::RNG before_ = cv::theRNG();
};

/// Runs on their way of becoming one.
class Meeting {
 public:
  Meeting(const std::vector<Run>& runs, const ProgressSink& progress, const WorkFile* work, graph::Mapper& mapper)
      : runs_(runs), progress_(progress), work_(work), mapper_(mapper) {}

  void begin() {
    const auto before = work_ == nullptr ? std::nullopt : work_->read();
    if (!before) {
      mapper_.restore(runs_.front().map.graph);
      return;
    }
    run_ = before->run;
    keyframes_ = before->keyframes;
    std::vector<const graph::SavedGraph*> known;
    for (std::size_t i = 0; i < run_ + (keyframes_ > 0 ? 1 : 0); ++i) known.push_back(&runs_[i].map.graph);
    mapper_.resume(known, before->state);
  }

  void goOn() {
    for (; run_ < runs_.size(); ++run_) {
      keyframesBefore_ = keyframesOf(runs_, run_);
      mapper_.meet(
          runs_[run_].map.graph, [this](const auto& /*update*/) { onKeyframe(); }, keyframes_);
      keyframes_ = 0;
      keep(run_ + 1);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kAtRisk{60};  // of a process that is killed

  void onKeyframe() {
    ++keyframes_;
    try {
      progress_({"keyframe", keyframesBefore_ + keyframes_, total_});
    } catch (...) {
      keep(run_);
      throw;
    }
    if (Clock::now() - kept_ > kAtRisk) keep(run_);
  }

  void keep(std::size_t run) {
    if (work_ != nullptr) work_->write({run, keyframes_, mapper_.state()});
    kept_ = Clock::now();
  }

  const std::vector<Run>& runs_;
  const ProgressSink& progress_;
  const WorkFile* work_;
  graph::Mapper& mapper_;
  std::size_t run_ = 1;        // that meets those before it
  std::size_t keyframes_ = 0;  // of it that have looked
  std::size_t keyframesBefore_ = 0;
  std::size_t total_ = keyframesOf(runs_, runs_.size());
  Clock::time_point kept_ = Clock::now();
};

}  // namespace

JoinedRuns joinRuns(const std::vector<Run>& runs, const pipeline::SlamOptions& options, const ProgressSink& progress,
                    const WorkFile* work) {
  const OwnRandomNumbers own;
  graph::Mapper mapper(options.graph, options.odometry);
  Meeting meeting(runs, progress, work, mapper);
  meeting.begin();
  meeting.goOn();
  mapper.adjustAll();
  JoinedRuns joined;
  for (const graph::Loop& loop : mapper.loops()) {
    if (runOf(runs, loop.older) != runOf(runs, loop.newer)) joined.looksBetweenRuns.push_back(loop);
  }
  joined.joins = mapper.joins();
  joined.graph = graph::save(mapper.graph());
  joined.graph.loops = mapper.loops();
  for (const auto& keyframe : joined.graph.keyframes) joined.T_joined_cam[keyframe->id] = keyframe->T_map_cam;
  joined.pieces = mapper.pieces();
  joined.map = largestOf(joined.pieces);
  return joined;
}

Eigen::Isometry3d motionAround(const std::function<double(const Eigen::Vector3d&)>& away_m, const Run& run,
                               std::uint32_t piece, const JoinedRuns& joined) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double least_m = std::numeric_limits<double>::infinity();
  for (const auto& [id, keyframe] : run.map.semantic.keyframes) {
    const auto placed = joined.T_joined_cam.find(id);
    if (keyframe.piece != piece || placed == joined.T_joined_cam.end()) continue;
    const double here_m = away_m(keyframe.T_map_cam.translation());
    if (here_m >= least_m) continue;
    least_m = here_m;
    const bool isWhereItWas = placed->second.matrix() == keyframe.T_map_cam.matrix();
    motion = isWhereItWas ? Eigen::Isometry3d::Identity() : placed->second * keyframe.T_map_cam.inverse();
  }
  return motion;
}

}  // namespace wardslam::merging
