#include "wardslam/change/instance_motion.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "wardslam/change/surface_samples.h"

namespace wardslam::change {
namespace {

constexpr double kWindow_s = 1.0;
constexpr double kBetweenMoments_s = 0.1;  // neighbouring images say the same
constexpr int kSamples = 400;              // of the box around a thing
constexpr int kSceneSamples = 600;

constexpr double kMostLogOdds = 4.0;
constexpr double kForRest = 4.0;     // of a thing that was where it is for the whole window
constexpr double kForMotion = 12.0;  // of a thing that is elsewhere altogether; a third of it is enough
constexpr double kNews = 0.5;        // share of the newest image in what is known
constexpr double kKept = 0.95;       // of what is known, per image that tells nothing
constexpr int kFew = 15;             // fewer points tell nothing
constexpr double kNoise = 0.1;       // share that seems to have come or gone as contours and depth are rough

/// What a depth image shows where a point should be.
enum class Seen { Unknown, Same, Through };

Seen look(const Eigen::Vector3d& p_cam_m, const core::CameraModel& camera, const cv::Mat& depth_m,
          const cv::Mat& movers) {
  constexpr double kNearest_m = 0.3;
  constexpr int kReach_px = 4;  // what a small error of the pose could show instead
  constexpr double kBase_m = 0.04;
  constexpr double kSigmas = 4.0;
  if (p_cam_m.z() < kNearest_m) return Seen::Unknown;
  const Eigen::Vector2d px = camera.projectDistorted(p_cam_m);
  const cv::Point at(cvRound(px.x()), cvRound(px.y()));
  const cv::Rect around(at.x - kReach_px, at.y - kReach_px, 2 * kReach_px + 1, 2 * kReach_px + 1);
  if ((around & cv::Rect({}, depth_m.size())) != around) return Seen::Unknown;
  double nearest = 1e9;
  double farthest = 0.0;
  for (int dy = -kReach_px; dy <= kReach_px; dy += kReach_px / 2) {
    for (int dx = -kReach_px; dx <= kReach_px; dx += kReach_px / 2) {
      const auto depth = static_cast<double>(depth_m.at<float>(at.y + dy, at.x + dx));
      if (depth <= 0) return Seen::Unknown;
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
  const double z = p_cam_m.z();
  const double limit_m =
      kBase_m + kSigmas * std::hypot(camera.depthNoise.sigma_m(z), camera.depthNoise.sigma_m(nearest));
  if (nearest - z > limit_m) return Seen::Through;
  const bool isHidden = z - farthest > limit_m;
  const bool mayBeAnother = movers.at<std::uint8_t>(at) != 0;  // who follows a trolley is soon where it was
  return isHidden || mayBeAnother ? Seen::Unknown : Seen::Same;
}

struct Tally {
  int same = 0;
  int through = 0;

  void add(Seen seen) {
    same += seen == Seen::Same ? 1 : 0;
    through += seen == Seen::Through ? 1 : 0;
  }
  /// Share of the points that are elsewhere; nothing where too few of them tell.
  [[nodiscard]] std::optional<double> changed() const {
    const int decided = same + through;
    return decided < kFew ? std::nullopt : std::optional(static_cast<double>(through) / decided);
  }
};

/// By the share of the thing that changed since an image that is `span` of the window older.
double evidenceOf(double changed, double noise, double span) {
  return changed > noise ? std::min(kForMotion * (changed - noise), kMostLogOdds) : -kForRest * span;
}

}  // namespace

InstanceMotion::InstanceMotion(const knowledge::MotionRules& rules) : rules_(rules), isMover_(1, 256, CV_8UC1) {
  for (int c = 0; c < 256; ++c) isMover_.at<std::uint8_t>(c) = rules.isMoving(static_cast<core::ClassId>(c)) ? 255 : 0;
}

void InstanceMotion::update(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam) {
  Moment now = momentOf(frame, T_map_cam);
  if (!past_.empty() && now.stamp_s <= past_.back().stamp_s) past_.clear();
  while (!past_.empty() && now.stamp_s - past_.front().stamp_s > kWindow_s) past_.pop_front();

  std::map<std::uint16_t, double> found;
  for (const Moment* past : references(now.stamp_s)) compare(*past, now, found);
  std::map<std::uint16_t, double> present;
  for (const auto& [id, points] : now.things) {
    const auto news = found.find(id);
    const double known = evidence(id);
    present[id] = news == found.end() ? kKept * known : known + kNews * (news->second - known);
  }
  logOdds_ = std::move(present);
  if (past_.empty() || now.stamp_s - past_.back().stamp_s >= kBetweenMoments_s) past_.push_back(std::move(now));
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

std::vector<const InstanceMotion::Moment*> InstanceMotion::references(double stamp_s) const {
  std::vector<const Moment*> chosen;
  for (const double share :
       {1.0, 0.4, 0.2}) {  // slow things need long, things that have just begun to move a short time
    const auto moment = std::find_if(past_.begin(), past_.end(),
                                     [&](const Moment& m) { return stamp_s - m.stamp_s <= share * kWindow_s; });
    if (moment != past_.end() && (chosen.empty() || chosen.back() != &*moment)) chosen.push_back(&*moment);
  }
  return chosen;
}

void InstanceMotion::compare(const Moment& past, const Moment& now, std::map<std::uint16_t, double>& evidence) {
  // What came and what left are told apart: one of them may be hidden.
  const auto changed = [&](const Points& before, const Points& after) {
    Tally came;
    Tally left;
    for (const auto& p : after) came.add(look(past.T_cam_map * p, past.camera, past.depth_m, past.movers));
    for (const auto& p : before) left.add(look(now.T_cam_map * p, now.camera, now.depth_m, now.movers));
    return std::max(came.changed(), left.changed());
  };
  const double noise = std::max(kNoise, 3 * changed(past.scene, now.scene).value_or(0.0));
  const double span = (now.stamp_s - past.stamp_s) / kWindow_s;
  for (const auto& [id, points] : now.things) {
    const auto before = past.things.find(id);
    const auto share = changed(before == past.things.end() ? Points{} : before->second, points);
    if (!share) continue;
    const double e = evidenceOf(*share, noise, span);
    double& strongest = evidence.emplace(id, e).first->second;
    strongest = e > 0 || strongest > 0 ? std::max(strongest, e) : std::min(strongest, e);  // seen moving once is moving
  }
}

}  // namespace wardslam::change
