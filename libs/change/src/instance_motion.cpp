#include "wardslam/change/instance_motion.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "evidence.h"
#include "moment_window.h"
#include "wardslam/change/surface_samples.h"

namespace wardslam::change {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kWindow_s = 1.0;
constexpr double kBetweenMoments_s = 0.1;  // neighbouring images say the same
constexpr int kSamples = 400;              // of the box around a thing
constexpr int kSceneSamples = 600;

constexpr double kNews = 0.5;   // share of the newest image in what is known
constexpr double kKept = 0.95;  // of what is known, per image that tells nothing
constexpr double kNoise = 0.1;  // share that seems to have come or gone as contours and depth are rough

/// What full-size depth shows around a pixel; nothing where it is without depth in part.
std::optional<DepthRange> depthRangeAt(const cv::Mat& depth_m, const cv::Point& at) {
  constexpr int kReach_px = 4;  // what a small error of the pose could show instead
  const cv::Rect around(at.x - kReach_px, at.y - kReach_px, 2 * kReach_px + 1, 2 * kReach_px + 1);
  if ((around & cv::Rect({}, depth_m.size())) != around) return std::nullopt;
  DepthRange range{1e9, 0.0};
  for (int dy = -kReach_px; dy <= kReach_px; dy += kReach_px / 2) {
    for (int dx = -kReach_px; dx <= kReach_px; dx += kReach_px / 2) {
      const auto depth = static_cast<double>(depth_m.at<float>(at.y + dy, at.x + dx));
      if (depth <= 0) return std::nullopt;
      range.nearest_m = std::min(range.nearest_m, depth);
      range.farthest_m = std::max(range.farthest_m, depth);
    }
  }
  return range;
}

}  // namespace

/// An image of the last second.
struct InstanceMotion::Moment {
  double stamp_s = 0.0;
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  core::CameraModel camera;
  cv::Mat depth_m;
  cv::Mat movers;                          ///< CV_8UC1, not 0 on what moves by itself.
  std::map<std::uint16_t, Points> things;  ///< Points on each movable instance, in the map frame.
  Points scene;                            ///< Points on none, nor on what moves by itself.

  [[nodiscard]] Seen look(const Eigen::Vector3d& p_map_m) const {
    const Eigen::Vector3d p_cam = T_cam_map * p_map_m;
    const auto px = pixelOf(p_cam, camera);
    if (!px) return Seen::Unknown;
    const cv::Point at(cvRound(px->x()), cvRound(px->y()));
    const auto shown = depthRangeAt(depth_m, at);
    if (!shown) return Seen::Unknown;
    const Seen seen = seenAt(p_cam.z(), *shown, camera.depthNoise, camera.depthNoise);
    const bool mayBeAnother = movers.at<std::uint8_t>(at) != 0;  // who follows a trolley is soon where it was
    return seen == Seen::Same && mayBeAnother ? Seen::Unknown : seen;
  }

  [[nodiscard]] const Points& thing(std::uint16_t id) const {
    static const Points kNone;
    const auto found = things.find(id);
    return found == things.end() ? kNone : found->second;
  }
};

namespace {

/// Share of a surface that is elsewhere, from its points in an image before and in one after. What came and what left
/// are told apart: one of them may be hidden.
template <class Moment>
std::optional<double> changed(const Moment& past, const Points& before, const Moment& now, const Points& after) {
  SurfaceTally came;
  SurfaceTally left;
  for (const auto& p : after) came.add(past.look(p));
  for (const auto& p : before) left.add(now.look(p));
  return std::max(came.changed(), left.changed());
}

}  // namespace

InstanceMotion::InstanceMotion(const knowledge::MotionRules& rules)
    : rules_(rules), isMover_(1, 256, CV_8UC1), past_(std::make_unique<MomentWindow<Moment>>(kWindow_s)) {
  for (int c = 0; c < 256; ++c) isMover_.at<std::uint8_t>(c) = rules.isMoving(static_cast<core::ClassId>(c)) ? 255 : 0;
}

InstanceMotion::~InstanceMotion() = default;
InstanceMotion::InstanceMotion(InstanceMotion&&) noexcept = default;

void InstanceMotion::forgetImages() { past_->clear(); }

void InstanceMotion::update(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam) {
  Moment now = momentOf(frame, T_map_cam);
  past_->advanceTo(now.stamp_s);
  const auto found = newsOf(now);
  std::map<std::uint16_t, double> present;
  for (const auto& [id, points] : now.things) {
    const auto news = found.find(id);
    present[id] = news == found.end() ? updated(evidence(id), kKept, 0.0)
                                      : updated(evidence(id), 1.0 - kNews, kNews * news->second);
  }
  logOdds_ = std::move(present);
  if (past_->empty() || now.stamp_s - past_->newest().stamp_s >= kBetweenMoments_s) past_->add(std::move(now));
}

double InstanceMotion::evidence(std::uint16_t instanceId) const {
  const auto found = logOdds_.find(instanceId);
  return found == logOdds_.end() ? 0.0 : found->second;
}

InstanceMotion::Moment InstanceMotion::momentOf(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam) const {
  Moment moment;
  moment.stamp_s = frame.stamp_s;
  moment.T_cam_map = T_map_cam.inverse();
  moment.camera = frame.camera;
  moment.depth_m = frame.depth_m;
  cv::LUT(frame.segmentation.classIds, isMover_, moment.movers);
  const auto inMap = [&](Points points) {
    for (Eigen::Vector3d& p : points) p = T_map_cam * p;
    return points;
  };
  const core::Segmentation& segmentation = frame.segmentation;
  for (const core::Instance& instance : segmentation.instances) {
    if (!rules_.isMovable(instance.classId)) continue;
    moment.things[instance.id] = inMap(sampleSurface(frame, instance.box_px, kSamples, [&](int y, int x) {
      return segmentation.instanceIds.at<std::uint16_t>(y, x) == instance.id;
    }));
  }
  if (moment.things.empty()) return moment;
  const auto isScene = [&](int y, int x) {
    const auto c = segmentation.classIds.at<core::ClassId>(y, x);
    return !rules_.isMovable(c) && !rules_.isMoving(c);
  };
  moment.scene = inMap(sampleSurface(frame, cv::Rect({}, frame.depth_m.size()), kSceneSamples, isScene));
  return moment;
}

std::map<std::uint16_t, double> InstanceMotion::newsOf(const Moment& now) const {
  std::map<std::uint16_t, double> news;
  for (const Moment* past : past_->references(now.stamp_s)) {
    const double noise = std::max(kNoise, 3 * changed(*past, past->scene, now, now.scene).value_or(0.0));
    const double baseline = past_->baseline(*past, now.stamp_s);
    for (const auto& [id, points] : now.things) {
      const auto share = changed(*past, past->thing(id), now, points);
      if (share) news[id] = combined(news[id], evidenceOfSurface(*share, noise, baseline));
    }
  }
  return news;
}

}  // namespace wardslam::change
