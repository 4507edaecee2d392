#include "synthesis/recording_camera.h"

#include <algorithm>
#include <cmath>

namespace wardslam::synth {
namespace {

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

/// How far the image moves from a to b: what is far by the turn, what is near by the way, too.
double motionOf_px(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double focal_px) {
  constexpr double kNear_m = 1.0;
  const Eigen::Isometry3d between = a.inverse() * b;
  const double turn_rad = Eigen::AngleAxisd(between.linear()).angle();
  return focal_px * (turn_rad + between.translation().norm() / kNear_m);
}

/// People walk by, whatever the camera does.
double motionOfPeople_px(double exposure_s, double focal_px) {
  constexpr double kWalk_mps = 1.2;
  constexpr double kDistance_m = 2.0;
  return focal_px * kWalk_mps * exposure_s / kDistance_m;
}

/// What the hand hides is nothing of the place, and it moves.
void coverTruth(SequenceFrame& frame, double share) {
  const int row = firstCoveredRow(share, frame.dynamic.rows);
  frame.dynamic.rowRange(row, frame.dynamic.rows).setTo(255);
  frame.instanceIds.rowRange(row, frame.instanceIds.rows).setTo(0);
}

}  // namespace

RecordingCamera::RecordingCamera(const Setting& setting, const SynthesisOptions& options)
    : setting_(setting), options_(options), model_(modelOf(options.camera)), renderer_(setting.scene, model_) {}

/// The mean of what an eye beside the camera sees while the shutter is open.
cv::Mat RecordingCamera::smeared(double t_s, const Eigen::Isometry3d& T_cam_eye) const {
  const double exposure_s = options_.sensor.exposure.motionBlur_ms / 1000.0;
  const double opens_s = t_s - exposure_s / 2;
  const double motion_px =
      std::max(motionOf_px(setting_.T_world_cam(opens_s), setting_.T_world_cam(opens_s + exposure_s), model_.fx_px),
               motionOfPeople_px(exposure_s, model_.fx_px));
  const int samples = blurSamples(motion_px);
  cv::Mat sum;
  for (int i = 0; i < samples; ++i) {
    const double at_s = opens_s + exposure_s * (i + 0.5) / samples;
    const cv::Mat color = renderer_.renderColor(at_s, setting_.T_world_cam(at_s) * T_cam_eye);
    if (sum.empty()) sum = cv::Mat::zeros(color.size(), CV_32FC3);
    cv::add(sum, color, sum, cv::noArray(), CV_32F);
  }
  sum.convertTo(sum, CV_8U, 1.0 / samples);
  return sum;
}

cv::Mat RecordingCamera::measured(const Rendering& rendering, double coveredShare, std::uint64_t seed) const {
  const SensorOptions& sensor = options_.sensor;
  const double noise = sensor.kinect.depthNoise;
  cv::Mat depth_m;
  switch (sensor.depth) {
    case DepthSensor::Tof:
      depth_m = measureByTof(rendering.depth_m, rendering.color_bgr, noise, seed);
      break;
    case DepthSensor::Stereo:
      depth_m = measureByStereo(rendering.depth_m, model_.fx_px, noise, seed);
      break;
    case DepthSensor::Perfect: {
      KinectOptions perfect = sensor.kinect;
      perfect.depthNoise = 0.0;
      depth_m = measureDepth(rendering.depth_m, perfect, seed);
      break;
    }
    case DepthSensor::Kinect:
      depth_m = measureDepth(rendering.depth_m, sensor.kinect, seed);
      break;
  }
  depth_m.rowRange(firstCoveredRow(coveredShare, depth_m.rows), depth_m.rows).setTo(0);  // nearer than any of them can
  return depth_m;
}

SequenceFrame RecordingCamera::shoot(std::size_t index) const {
  const SensorOptions& sensor = options_.sensor;
  const std::uint32_t seed = options_.place.scene.seed;
  const double t_s = timeOf(index, options_.camera.rate_hz);
  SequenceFrame frame;
  frame.stamp_s = firstStamp_s(options_.place) + t_s;
  frame.T_world_cam = setting_.T_world_cam(t_s);
  const bool isSmeared = sensor.exposure.motionBlur_ms > 0;
  const double covered = coveredShare(sensor.mishaps.covers, t_s);
  const double gain = sensor.exposure.jumps ? gainAt(t_s, seed) : 1.0;
  const auto exposed = [&](cv::Mat light_bgr, std::uint64_t picture) {
    if (covered > 0) coverColor(light_bgr, covered);
    return expose(light_bgr, sensor.exposure, sensor.kinect, gain, noiseSeed(seed, index, picture));
  };

  const Rendering rendering = renderer_.render(t_s, frame.T_world_cam);
  const auto eye = [&](const Eigen::Isometry3d& T_cam_eye) {
    return isSmeared ? smeared(t_s, T_cam_eye) : renderer_.renderColor(t_s, frame.T_world_cam * T_cam_eye);
  };
  frame.color_bgr = exposed(isSmeared ? smeared(t_s, Eigen::Isometry3d::Identity()) : rendering.color_bgr.clone(), 0);
  if (options_.camera.stereoBaseline_m) {
    const Eigen::Translation3d toTheRight(*options_.camera.stereoBaseline_m, 0, 0);
    frame.right_bgr = exposed(eye(Eigen::Isometry3d(toTheRight)), 1);
  } else {
    frame.depth_m = measured(rendering, covered, noiseSeed(seed, index, 1));
  }
  frame.instanceIds = rendering.instanceIds;
  frame.dynamic = dynamicMask(rendering.instanceIds, setting_.scene, t_s);
  if (covered > 0) coverTruth(frame, covered);
  return frame;
}

}  // namespace wardslam::synth
