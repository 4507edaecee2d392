#include "synthesis.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <vector>

#include "renderer.h"
#include "sequence_writer.h"

namespace wardslam::synth {
namespace {

std::vector<Label> allLabels(const Scene& scene) {
  std::vector<Label> labels;
  for (const Thing& thing : scene.things) labels.push_back(thing.label);
  for (const auto& actor : scene.actors) labels.push_back(actor->label());
  return labels;
}

Eigen::AlignedBox3f boundsOf(const Surfaces& surfaces) {
  Eigen::AlignedBox3f box;
  for (const Surface& surface : surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) box.extend(vertex.p_m);
  }
  return box;
}

std::vector<StaticObject> staticObjects(const Scene& scene, double seconds) {
  std::vector<StaticObject> objects;
  for (const Thing& thing : scene.things) {
    if (thing.label.id != 0) objects.push_back({thing.label, boundsOf(thing.surfaces), 0.0});
  }
  for (const auto& actor : scene.actors) {
    const double from_s = actor->atRestFrom_s();
    if (from_s < seconds) objects.push_back({actor->label(), boundsOf(actor->surfacesAt(from_s)), from_s});
  }
  std::sort(objects.begin(), objects.end(), [](const auto& a, const auto& b) { return a.label.id < b.label.id; });
  return objects;
}

cv::Mat dynamicMask(const cv::Mat& instanceIds, const Scene& scene, double t_s) {
  cv::Mat mask = cv::Mat::zeros(instanceIds.size(), CV_8UC1);
  for (const auto& actor : scene.actors) {
    if (actor->isMovingAt(t_s)) mask.setTo(255, instanceIds == static_cast<int>(actor->label().id));
  }
  return mask;
}

/// Every picture has its own noise, whatever was rendered before it.
std::uint64_t noiseSeed(std::uint32_t seed, std::size_t frame, std::uint64_t picture) {
  return (static_cast<std::uint64_t>(seed) << 32U) + 2 * static_cast<std::uint64_t>(frame) + picture + 1;
}

/// Seconds after the start, such that stamps are whole microseconds.
double timeOf(std::size_t frame, double rate_hz) {
  return std::round(static_cast<double>(frame) / rate_hz * 1e6) / 1e6;
}

std::size_t frameCount(double seconds, double rate_hz) {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds * rate_hz)));
}

SequenceFrame record(const Rendering& rendering, const cv::Mat& right_bgr, const Setting& setting,
                     const SynthesisOptions& options, std::size_t index) {
  const double t_s = timeOf(index, options.camera.rate_hz);
  SequenceFrame frame;
  frame.stamp_s = kFirstStamp_s + t_s;
  frame.color_bgr =
      exposeColor(rendering.color_bgr, options.sensor.kinect, noiseSeed(options.place.scene.seed, index, 0));
  const std::uint64_t secondSeed = noiseSeed(options.place.scene.seed, index, 1);
  if (options.camera.stereoBaseline_m) {
    frame.right_bgr = exposeColor(right_bgr, options.sensor.kinect, secondSeed);
  } else {
    frame.depth_m = measureDepth(rendering.depth_m, options.sensor.kinect, secondSeed);
  }
  frame.instanceIds = rendering.instanceIds;
  frame.dynamic = dynamicMask(rendering.instanceIds, setting.scene, t_s);
  frame.T_world_cam = setting.T_world_cam(t_s);
  return frame;
}

/// What the right camera of a stereo camera sees; empty where there is none.
cv::Mat renderRight(Renderer& renderer, const SynthesisOptions& options, double t_s,
                    const Eigen::Isometry3d& T_world_cam) {
  if (!options.camera.stereoBaseline_m) return {};
  const Eigen::Translation3d toTheRight(*options.camera.stereoBaseline_m, 0, 0);
  return renderer.render(t_s, T_world_cam * toTheRight).color_bgr;
}

}  // namespace

std::size_t synthesise(const SynthesisOptions& options, const std::function<bool(std::size_t, std::size_t)>& goOn) {
  const core::CameraModel camera = cameraFor(options.camera.width_px, options.camera.height_px);
  const Setting setting = buildPlace(options.place, options.camera.mount);
  Renderer renderer(setting.scene, camera);
  SequenceWriter writer(options.output.file, {camera, options.camera.stereoBaseline_m}, allLabels(setting.scene));

  const std::size_t total = frameCount(options.output.seconds.value_or(setting.duration_s), options.camera.rate_hz);
  std::size_t done = 0;
  std::future<void> recording;  // of the frame before, while the next one is rendered
  while (done < total) {
    const double t_s = timeOf(done, options.camera.rate_hz);
    const Eigen::Isometry3d T_world_cam = setting.T_world_cam(t_s);
    const Rendering rendering = renderer.render(t_s, T_world_cam);
    const cv::Mat right_bgr = renderRight(renderer, options, t_s, T_world_cam);
    if (recording.valid()) recording.get();
    recording = std::async(std::launch::async, [&, rendering, right_bgr, done] {
      writer.write(record(rendering, right_bgr, setting, options, done));
    });
    if (!goOn(++done, total)) break;
  }
  recording.get();
  const double seconds = static_cast<double>(done) / options.camera.rate_hz;
  writer.finish(staticObjects(setting.scene, seconds), setting.floorPlan(setting.scene, seconds),
                [&](const std::filesystem::path& folder) {
                  if (setting.writeFurtherTruth) setting.writeFurtherTruth(folder, seconds);
                });
  return done;
}

}  // namespace wardslam::synth
