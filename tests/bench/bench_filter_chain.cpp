// The chain of filters as it ships, with depth: what it adds to a frame beside the network. The paper's own has 17.21
// ms (docs/benchmark.md).

#include <benchmark/benchmark.h>

#include <utility>

#include "moving_scene.h"
#include "wardslam/core/data_files.h"
#include "wardslam/features/orb_extractor.h"
#include "wardslam/filters/filter_chain.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/masks/async_segmenter.h"

namespace wardslam {
namespace {

constexpr int kMoments = 30;
constexpr double kStep_s = 1.0 / 30;

/// Has the masks of the image at hand.
class PreparedSegmenter : public segmentation::Segmenter {
 public:
  explicit PreparedSegmenter(std::shared_ptr<const core::Segmentation> masks) : masks_(std::move(masks)) {}
  Result segment(const segmentation::SegmenterInput&) override { return {*masks_, {}}; }
  const core::LabelSpace& labelSpace() const override { return labels_; }

 private:
  std::shared_ptr<const core::Segmentation> masks_;
  core::LabelSpace labels_ = core::LabelSpace::coco();
};

struct Shot {
  core::Frame frame;  ///< With key points.
  core::Segmentation masks;
};

Shot shotAt(int moment, int instances, int keypoints) {
  bench::Scene scene = bench::sceneAt(moment, instances);
  Shot shot;
  shot.masks = std::move(scene.masks);
  shot.frame.gray = scene.gray;
  shot.frame.depth_m = scene.depth_m;
  cv::cvtColor(scene.gray, shot.frame.color_bgr, cv::COLOR_GRAY2BGR);
  features::OrbOptions options;
  options.key_points = keypoints;
  features::OrbExtractor(options).extract(shot.frame);
  return shot;
}

Eigen::Isometry3d poseAt(int moment, const core::CameraModel& camera) {
  const double turn_rad = -moment * bench::kWallShift_px / camera.fx_px;
  return Eigen::Isometry3d(Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()));
}

/// There and back again, so that what is seen goes on as it went.
int momentOf(int index) {
  const int way = index % (2 * kMoments - 2);
  return way < kMoments ? way : 2 * kMoments - 2 - way;
}

/// begin(), apply() and end() of every filter: margins, judge, dynamic test, points followed, depth compared.
void filterChain(benchmark::State& state) {
  cv::setNumThreads(1);
  const auto masks = std::make_shared<core::Segmentation>();
  const auto shipped = core::ConfigNode::fromFile(core::findDataFile("wardslam.yaml")).child("filters");
  filters::FilterChain chain(shipped,
                             {std::make_shared<masks::AsyncSegmenter>(std::make_unique<PreparedSegmenter>(masks)),
                              std::make_shared<knowledge::KnowledgeGraph>(
                                  knowledge::KnowledgeGraph::fromFile(core::findDataFile("knowledge/hospital.yaml")))});
  std::vector<Shot> shots;
  for (int moment = 0; moment < kMoments; ++moment) {
    shots.push_back(shotAt(moment, static_cast<int>(state.range(1)), static_cast<int>(state.range(0))));
  }
  int index = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const int moment = momentOf(index);
    core::Frame frame = shots[static_cast<std::size_t>(moment)].frame;
    *masks = shots[static_cast<std::size_t>(moment)].masks;
    frame.index = static_cast<std::uint64_t>(index);
    frame.stamp_s = index++ * kStep_s;
    state.ResumeTiming();
    chain.begin(frame);
    chain.apply(frame);
    chain.end(frame, poseAt(moment, frame.camera));
  }
}
BENCHMARK(filterChain)
    ->ArgNames({"key points", "people and chairs"})
    ->ArgsProduct({{500, 1000, 1500, 3000}, {0, 4, 8}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace wardslam
