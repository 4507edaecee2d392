#include "instance_contour.h"

#include <array>
#include <opencv2/imgproc.hpp>

#include "color_evidence.h"
#include "dominant_plane.h"

namespace wardslam::masks {
namespace {

constexpr int kRing_px = 16;          // of surroundings that stand for the background
constexpr int kGap_px = 2;            // between mask and ring, as the outline is uncertain
constexpr int kNetworkError_px = 4;   // how far off outlines usually are: one cell of a network's mask
constexpr float kMinEvidence = 0.3F;  // from which a colour speaks for the background

cv::Mat widened(const cv::Mat& mask, int radius_px) {
  cv::Mat result;
  cv::dilate(mask, result, cv::getStructuringElement(cv::MORPH_RECT, {2 * radius_px + 1, 2 * radius_px + 1}));
  return result;
}

cv::Mat narrowed(const cv::Mat& mask, int radius_px) {
  cv::Mat result;
  cv::erode(mask, result, cv::getStructuringElement(cv::MORPH_RECT, {2 * radius_px + 1, 2 * radius_px + 1}));
  return result;
}

/// All pixels reached from `seeds` in at most `steps` steps to 4-neighbours, each allowed by mayStep(from, to).
template <class MayStep>
cv::Mat reachedFrom(const cv::Mat& seeds, int steps, const MayStep& mayStep) {
  const std::array<cv::Point, 4> directions = {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}};
  const cv::Rect image({}, seeds.size());
  cv::Mat reached = seeds.clone();
  std::vector<cv::Point> front;
  std::vector<cv::Point> next;
  cv::findNonZero(seeds & ~narrowed(seeds, 1), front);  // others have no way to go
  for (int step = 0; step < steps && !front.empty(); ++step) {
    next.clear();
    for (const cv::Point& from : front) {
      for (const cv::Point& direction : directions) {
        const cv::Point to = from + direction;
        if (!image.contains(to) || reached.at<std::uint8_t>(to) != 0 || !mayStep(from, to)) continue;
        reached.at<std::uint8_t>(to) = 255;
        next.push_back(to);
      }
    }
    front.swap(next);
  }
  return reached;
}

}  // namespace

InstanceContour::InstanceContour(const InstanceCrop& view, const ContourOptions& options)
    : view_(view),
      options_(options),
      measured_(view.inverseDepth > 0),
      available_(view.isFree | view.mask),
      mask_(view.mask.clone()) {}

cv::Mat InstanceContour::refined() {
  const cv::Mat surroundings = widened(view_.mask, kRing_px);
  const cv::Mat ring = surroundings & ~widened(view_.mask, kGap_px) & view_.isFree;
  onPlane_ = dominantPlane(view_.inverseDepth, ring, view_.depthNoise);
  surfaces_ = findSurfaces(view_.inverseDepth, onPlane_, view_.depthNoise);
  removeForeignSurfaces();
  const cv::Mat outside = surroundings & ~mask_ & available_ & measured_;
  looksLikeOutside_ = backgroundEvidence(view_.color_bgr, mask_ & measured_, outside) > kMinEvidence;
  grow();
  settleUnmeasured();
  return mask_;
}

void InstanceContour::removeForeignSurfaces() {
  const std::vector<char> isForeign = findForeignSurfaces();
  foreign_.create(mask_.size(), CV_8UC1);
  for (int y = 0; y < foreign_.rows; ++y) {
    const auto* label = surfaces_.labels.ptr<int>(y);
    auto* row = foreign_.ptr<std::uint8_t>(y);
    for (int x = 0; x < foreign_.cols; ++x) row[x] = isForeign[static_cast<std::size_t>(label[x])] != 0 ? 255 : 0;
  }
  mask_.setTo(0, foreign_);
}

/// Those mostly outside the mask, and those behind the thing: between arm and body, or between the legs, a network
/// often fills in what is seen there.
std::vector<char> InstanceContour::findForeignSurfaces() const {
  constexpr double kMaxPart = 0.4;  // of the thing; a larger one is the thing
  struct Part {
    int all_px = 0;
    int inside_px = 0;
    double inverseDepth = 0.0;  ///< Sum, inside.
  };
  std::vector<Part> parts(static_cast<std::size_t>(surfaces_.count));
  for (int y = 0; y < mask_.rows; ++y) {
    const auto* label = surfaces_.labels.ptr<int>(y);
    const auto* isIn = mask_.ptr<std::uint8_t>(y);
    const auto* w = view_.inverseDepth.ptr<float>(y);
    for (int x = 0; x < mask_.cols; ++x) {
      Part& part = parts[static_cast<std::size_t>(label[x])];
      ++part.all_px;
      if (isIn[x] == 0) continue;
      ++part.inside_px;
      part.inverseDepth += w[x];
    }
  }
  const double depth_m = 1.0 / view_.medianInverseDepth;
  const int thing_px = cv::countNonZero(mask_ & measured_);
  std::vector<char> isForeign(parts.size(), 0);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Part& part = parts[i];
    const bool isOutside = part.inside_px < options_.min_surface_share * part.all_px;
    const bool isBehind = part.inside_px > part.inverseDepth * (depth_m + options_.max_behind_m);
    isForeign[i] = isOutside || (isBehind && part.inside_px < kMaxPart * thing_px) ? 1 : 0;
  }
  return isForeign;
}

/// A surface that comes in from beyond the reach of growth is left out as far as it can be followed from there.
void InstanceContour::grow() {
  const int reach_px = view_.maxGrowth_px;
  if (reach_px < 1) return;
  const cv::Mat within = widened(view_.mask, reach_px);
  const cv::Mat rim = widened(within, kGap_px) & ~within & view_.isFree & measured_;
  const cv::Mat near = within & available_;
  const cv::Mat fromBeyond = reachedFrom(rim, reach_px + reach_px / 2, [&](cv::Point from, cv::Point to) {
    return near.at<std::uint8_t>(to) != 0 && isJoined(from, to);
  });
  const cv::Mat open = available_ & ~foreign_ & ~onPlane_ & ~fromBeyond & (view_.mask | ~looksLikeOutside_);
  mask_ = reachedFrom(mask_, reach_px, [&](cv::Point from, cv::Point to) {
    return open.at<std::uint8_t>(to) != 0 && isJoined(from, to);
  });
}

void InstanceContour::settleUnmeasured() {
  constexpr int kShadow_px = 6;  // about as wide as the shadow of a person before a wall
  const cv::Mat thing = mask_ & measured_;
  const cv::Mat nearOutline = mask_ & ~narrowed(mask_, kNetworkError_px);
  mask_.setTo(0, nearOutline & ~measured_ & widened(thing, kShadow_px));
  // Depth ends about a pixel before the thing does.
  mask_.setTo(255, widened(thing, 1) & ~measured_ & available_);
  const cv::Rect box = cv::boundingRect(view_.mask);
  const int depth_px = std::min({3 * kNetworkError_px, box.width / 4, box.height / 4});
  mask_.setTo(0, ~narrowed(mask_, depth_px) & ~measured_ & looksLikeOutside_);
}

bool InstanceContour::isJoined(cv::Point a, cv::Point b) const {
  return surfaces_.labels.at<int>(a) == surfaces_.labels.at<int>(b) &&
         isContinuous(view_.inverseDepth.at<float>(a), view_.inverseDepth.at<float>(b), view_.depthNoise);
}

}  // namespace wardslam::masks
