// measure_cloud DIR [MASKS.onnx]: how right the semantic cloud of a run is. DIR is a recording in the layout of the TUM
// benchmark with true poses and true class ids in masks/ (1 = person). The run takes its masks from there, or from the
// YOLO-seg network. The cloud is moved onto the truth as the ATE does it, then every tenth frame looks at it from where
// it was truly taken. Prints
//   - the median difference between the nearest point in each patch of 4 × 4 pixels and the depth measured there, where
//     there is no person, and
//   - the share of points of people: that lie on one's surface in some frame, and on no other surface in any.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "association.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/error_statistics.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/segmentation/recorded_masks.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;

constexpr core::ClassId kPerson = 1;
constexpr int kPatch_px = 4;
constexpr int kMargin_px = 5;
constexpr double kOnSurface_m = 0.05;
constexpr std::size_t kEvery = 10;

pipeline::SlamOptions optionsFor(const fs::path& recording, const std::string& model) {
  using Type = segmentation::SegmentationOptions::Type;
  pipeline::SlamOptions options;
  options.deterministic = true;
  options.segmentation.type = model.empty() ? Type::RecordedMasks : Type::Yolo;
  options.segmentation.recorded_masks.folder = (recording / "masks").string();
  options.segmentation.yolo.model = model;
  return options;
}

std::vector<Eigen::Vector3d> cloudOf(const mapping::SemanticMap& map, const Eigen::Isometry3d& T_world_map) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& [id, tile] : map.cloud) {
    const Eigen::Isometry3d T_world_cam = T_world_map * map.keyframes.at(id).T_map_cam;
    for (const auto& point : tile.points) points.push_back(T_world_cam * point.p_cam_m.cast<double>());
  }
  return points;
}

/// What the frames say about the cloud.
class Inspection {
 public:
  explicit Inspection(std::vector<Eigen::Vector3d> points)
      : points_(std::move(points)), onPerson_(points_.size(), false), onThing_(points_.size(), false) {}

  void look(const core::Frame& frame, const Eigen::Isometry3d& T_world_cam, const cv::Mat& classIds) {
    cv::Mat person = classIds == kPerson;
    cv::Mat near;
    const int side = 2 * kMargin_px + 1;
    cv::dilate(person, near, cv::Mat::ones(side, side, CV_8UC1));
    cv::erode(person, person, cv::Mat::ones(side, side, CV_8UC1));
    std::map<std::pair<int, int>, std::pair<double, double>> nearest;  // by patch: depth of the point, error
    const Eigen::Isometry3d T_cam_world = T_world_cam.inverse();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector3d p = T_cam_world * points_[i];
      if (p.z() < 0.3) continue;
      const Eigen::Vector2d px = frame.camera.projectDistorted(p);
      const cv::Point pixel(static_cast<int>(std::lround(px.x())), static_cast<int>(std::lround(px.y())));
      if (!cv::Rect({}, frame.depth_m.size()).contains(pixel)) continue;
      const double measured_m = frame.depth_m.at<float>(pixel);
      if (measured_m <= 0) continue;
      const double error_m = std::abs(measured_m - p.z());
      const bool isOnSurface = error_m < kOnSurface_m;
      if (isOnSurface && person.at<std::uint8_t>(pixel) != 0) onPerson_[i] = true;
      if (near.at<std::uint8_t>(pixel) != 0) continue;
      if (isOnSurface) onThing_[i] = true;
      const auto [entry, isNew] =
          nearest.try_emplace({pixel.x / kPatch_px, pixel.y / kPatch_px}, std::pair(p.z(), error_m));
      if (!isNew && p.z() < entry->second.first) entry->second = {p.z(), error_m};
    }
    for (const auto& [patch, depthAndError] : nearest) errors_m_.push_back(depthAndError.second);
  }

  void print(const std::string& name) const {
    std::size_t people = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) people += onPerson_[i] && !onThing_[i] ? 1U : 0U;
    const auto errors = evaluation::summarise(errors_m_);
    std::printf("%s: %zu points, depth error median %.4f m over %zu patches, points of people %zu = %.3f %%\n",
                name.c_str(), points_.size(), errors.median, errors.samples, people,
                100.0 * static_cast<double>(people) / static_cast<double>(std::max<std::size_t>(points_.size(), 1)));
  }

 private:
  std::vector<Eigen::Vector3d> points_;  ///< World frame.
  std::vector<bool> onPerson_;
  std::vector<bool> onThing_;
  std::vector<double> errors_m_;
};

mapping::SemanticMap mapOf(const fs::path& recording, const std::string& model, core::Trajectory& trajectory) {
  pipeline::SlamSystem slam(optionsFor(recording, model), {}, pipeline::WhenBehind::Waits);
  const auto source = sources::openSource(recording, {});
  while (const auto observation = source->next()) slam.process(observation);
  slam.finish();
  trajectory = slam.trajectory();
  return slam.semanticMap();
}

void measure(const fs::path& recording, const std::string& model) {
  core::Trajectory trajectory;
  const auto map = mapOf(recording, model, trajectory);
  const auto truth = exchange::readTumTrajectory(recording / "groundtruth.txt");
  Inspection inspection(cloudOf(map, evaluation::absoluteTrajectoryError(truth, trajectory).T_groundtruth_estimate));

  segmentation::RecordedMasksOptions maskOptions;
  maskOptions.folder = (recording / "masks").string();
  segmentation::RecordedMasks masks(maskOptions);
  const auto source = sources::openSource(recording, {});
  sources::FrameBuilder builder;
  for (std::size_t i = 0; const auto observation = source->next(); ++i) {
    if (i % kEvery != 0) continue;
    const core::Frame frame = builder.build(observation);
    const auto pairs = evaluation::associate(truth, {{frame.stamp_s, Eigen::Isometry3d::Identity()}});
    if (pairs.empty()) continue;
    const auto result = masks.segment(segmentation::inputOf(frame));
    if (result.segmentation.empty()) continue;
    inspection.look(frame, truth[pairs.front().groundTruth].T_map_cam, result.segmentation.classIds);
  }
  inspection.print(recording.filename().string());
}

}  // namespace
}  // namespace wardslam

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: measure_cloud DIR [MASKS.onnx]\n");
    return 2;
  }
  try {
    wardslam::measure(argv[1], argc == 3 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "measure_cloud: %s\n", error.what());
    return 1;
  }
  return 0;
}
