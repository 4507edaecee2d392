#include "plots.h"

#include <cmath>

#include "stretches.h"

namespace wardslam::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 20000;

std::size_t strideOf(std::size_t rows) { return (rows + kMostRows - 1) / kMostRows; }

double rounded(double value, double steps) { return std::round(value * steps) / steps; }

class PlotWriter {
 public:
  explicit PlotWriter(double start_s) : start_s_(start_s) {}

  [[nodiscard]] double time(double stamp_s) const { return rounded(stamp_s - start_s_, 1e3); }

  /// `row`: what an element says besides its time.
  template <class Element, class Row>
  [[nodiscard]] Json rows(const std::vector<Element>& elements, const Row& row) const {
    Json list = Json::array();
    for (std::size_t i = 0; i < elements.size(); i += strideOf(elements.size())) {
      Json entry = row(elements[i]);
      entry.insert(entry.begin(), time(elements[i].stamp_s));
      list.push_back(std::move(entry));
    }
    return list;
  }

 private:
  double start_s_;
};

Json plot(const char* id, const char* title, const char* unit, const std::vector<std::string>& lines, Json rows) {
  return {{"id", id}, {"title", title}, {"unit", unit}, {"lines", lines}, {"rows", std::move(rows)}};
}

double sharePercent(const pipeline::FrameRow& frame) {
  if (frame.keypoints == 0) return 0.0;
  return rounded(100.0 * static_cast<double>(frame.dynamicKeypoints) / static_cast<double>(frame.keypoints), 10);
}

/// Nothing where there was none.
Json mapPerKeyframe(const pipeline::LoadRow& load) {
  if (load.keyframes == 0) return nullptr;
  return rounded(load.map_ms() / static_cast<double>(load.keyframes), 1e2);
}

}  // namespace

Json plotData(const RunRecord& run, const std::vector<evaluation::ErrorAt>& errors, const PlanView& plan) {
  const PlotWriter writer(run.start_s());
  Json plots = Json::array();
  if (!errors.empty()) {
    plots.push_back(plot("error", "Distance from the true position", "m", {"error"},
                         writer.rows(errors, [](const auto& e) { return Json::array({rounded(e.distance_m, 1e5)}); })));
  }
  if (!run.frames.empty()) {
    plots.push_back(plot("dynamic", "Key points left out as moving", "%", {"left out"},
                         writer.rows(run.frames, [](const auto& f) { return Json::array({sharePercent(f)}); })));
    plots.push_back(plot("keypoints", "Key points", "", {"found", "static", "pose rests on"},
                         writer.rows(run.frames, [](const auto& f) {
                           return Json::array({f.keypoints, f.keypoints - f.dynamicKeypoints, f.inliers});
                         })));
  }
  if (!run.load.empty()) {
    plots.push_back(plot("load", "Time per frame; of the map, per keyframe", "ms", {"frame", "map, per keyframe"},
                         writer.rows(run.load, [](const auto& l) {
                           return Json::array({rounded(l.frame_ms, 1e2), mapPerKeyframe(l)});
                         })));
    plots.push_back(plot("memory", "Memory", "MB", {"resident"},
                         writer.rows(run.load, [](const auto& l) { return Json::array({rounded(l.memory_mb, 10)}); })));
    plots.push_back(plot("waiting", "Waiting to be worked into the map; open files", "", {"waiting", "open files"},
                         writer.rows(run.load, [](const auto& l) {
                           return Json::array({l.waiting, l.openFiles});
                         })));
  }
  Json lost = Json::array();
  for (const auto& stretch : stretchesWithoutPose(run.frames)) {
    lost.push_back({writer.time(stretch.from_s), writer.time(stretch.to_s)});
  }
  const auto place = [&plan](const core::StampedPose& pose) {
    const cv::Point p = plan.at(pose.T_map_cam.translation());
    return Json::array({p.x, p.y});
  };
  return {{"plots", std::move(plots)},
          {"lost", std::move(lost)},
          {"way", writer.rows(run.trajectory, place)},
          {"stride", std::max<std::size_t>(1, strideOf(run.frames.size()))}};
}

}  // namespace wardslam::report
