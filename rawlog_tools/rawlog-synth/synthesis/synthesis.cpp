#include "synthesis/synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "output/rests.h"
#include "output/sequence_writer.h"
#include "scene/classes.h"
#include "synthesis/ordered_work.h"
#include "synthesis/recording_camera.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/mrpt_compat.h"

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

std::vector<StaticObject> staticObjects(const Setting& setting, double seconds) {
  const Scene& scene = setting.scene;
  std::vector<StaticObject> objects;
  for (const Thing& thing : scene.things) {
    // Whoever lies in bed is somebody, not something.
    const bool isObject = thing.label.id != 0 && thing.label.classId != kPerson;
    if (isObject) objects.push_back({thing.label, boundsOf(thing.surfaces), 0.0});
  }
  for (const auto& actor : scene.actors) {
    const auto rest = restAt(*actor, seconds);
    if (rest) objects.push_back({actor->label(), boundsOf(actor->surfacesAt(seconds)), rest->from_s});
  }
  for (StaticObject& object : objects) {
    const Eigen::Vector3d centre_m = object.box_m.center().cast<double>();
    if (setting.roomAt) object.room = setting.roomAt(centre_m);
    if (setting.storeyAt) object.storey = setting.storeyAt(centre_m.z());
  }
  std::sort(objects.begin(), objects.end(), [](const auto& a, const auto& b) { return a.label.id < b.label.id; });
  return objects;
}

std::size_t frameCount(double seconds, double rate_hz) {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds * rate_hz)));
}

/// Several threads share the pictures.
std::size_t threadsFor(std::size_t frames) {
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, frames);
}

/// Wheels and inertial sensor, in order of time.
class MotionRecorder {
 public:
  MotionRecorder(const Setting& setting, const SynthesisOptions& options) : first_s_(firstStamp_s(options.place)) {
    const auto T_world_sensor = [&setting](double t_s) -> Eigen::Isometry3d {
      return setting.T_world_cam(t_s) * core::T_sensor_cam().inverse();
    };
    const Eigen::Isometry3d T_sensor_base = statedMount(options.camera).inverse();
    const auto T_world_base = [=](double t_s) -> Eigen::Isometry3d { return T_world_sensor(t_s) * T_sensor_base; };
    const std::uint32_t seed = options.place.scene.seed;
    if (options.sensor.odometry) odometry_.emplace(T_world_base, *options.sensor.odometry, seed);
    if (options.sensor.imu) imu_.emplace(T_world_sensor, *options.sensor.imu, seed);
  }

  /// All that was measured until then and is not written yet.
  void writeUntil(double t_s, Recording& recording) {
    constexpr double kNever_s = std::numeric_limits<double>::infinity();
    while (true) {
      const double odometry_s = odometry_ ? odometry_->nextStamp_s() : kNever_s;
      const double imu_s = imu_ ? imu_->nextStamp_s() : kNever_s;
      if (std::min(odometry_s, imu_s) > t_s) return;
      if (odometry_s <= imu_s) {
        recording.writeOdometry(first_s_ + odometry_s, odometry_->next());
      } else {
        recording.writeImu(first_s_ + imu_s, imu_->next());
      }
    }
  }

 private:
  double first_s_;
  std::optional<WheelOdometry> odometry_;
  std::optional<Imu> imu_;
};

}  // namespace

double firstStamp_s(const PlaceOptions& place) {
  constexpr double kFirst_s = 1700000000.0;
  constexpr double kDay_s = 86400.0;
  constexpr double kHour_s = 3600.0;
  return kFirst_s + kDay_s * place.hospital.day + kHour_s * place.hospital.route.robot;
}

double timeOf(std::size_t frame, double rate_hz) {
  return std::round(static_cast<double>(frame) / rate_hz * 1e6) / 1e6;
}

std::size_t synthesise(const SynthesisOptions& options, const std::function<bool(std::size_t, std::size_t)>& goOn) {
  const double rate_hz = options.camera.rate_hz;
  const Setting setting = buildPlace(options.place, options.camera.mount);
  const std::size_t total = frameCount(options.output.seconds.value_or(setting.duration_s), rate_hz);
  const std::vector<bool> lost = lostFrames(total, options.sensor.mishaps.lostShare, options.place.scene.seed);
  SequenceWriter writer(
      options.output, {modelOf(options.camera), options.camera.stereoBaseline_m, statedMount(options.camera), rate_hz},
      allLabels(setting.scene));
  const RecordingCamera camera(setting, options);
  OrderedWork<EncodedFrame> work(total, threadsFor(total), [&](std::size_t index) -> EncodedFrame {
    const double t_s = timeOf(index, rate_hz);
    if (lost[index]) return {firstStamp_s(options.place) + t_s, setting.T_world_cam(t_s), {}, {}};
    return writer.encode(camera.shoot(index));
  });
  MotionRecorder motion(setting, options);
  std::size_t done = 0;
  while (done < total) {
    const EncodedFrame frame = work.take();
    motion.writeUntil(timeOf(done, rate_hz), writer.recording());
    writer.write(frame);
    if (!goOn(++done, total)) break;
  }
  const double seconds = static_cast<double>(done) / rate_hz;
  writer.finish(staticObjects(setting, seconds), setting.floorPlan(setting.scene, seconds),
                [&](const std::filesystem::path& folder) {
                  core::writeFileAtomically(folder / "rests.csv", restsText(setting.scene, seconds));
                  if (setting.writeFurtherTruth) setting.writeFurtherTruth(folder, seconds);
                });
  return done;
}

}  // namespace wardslam::synth
