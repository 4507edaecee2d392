#include "wardslam/masks/contour_refiner.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "depth_surfaces.h"
#include "instance_contour.h"

namespace wardslam::masks {
namespace {

constexpr double kMinDepthShare = 0.4;  // of a mask must be measured
constexpr double kMinKept = 0.4;        // of a mask; if less were left, what depth says is not to be trusted

/// The images at the resolution contours are worked out in.
struct SmallImages {
  int step = 1;  ///< Pixels of the frame per pixel.
  cv::Mat inverseDepth;
  core::DepthNoise depthNoise;
  cv::Mat color_bgr;
  cv::Mat instanceIds;
};

/// Columns and rows at the end that fill no step are left out.
cv::Mat everyNth(const cv::Mat& image, int step) {
  cv::Mat smaller;
  const cv::Size size(image.cols / step, image.rows / step);
  cv::resize(image({{}, size * step}), smaller, size, 0, 0, cv::INTER_NEAREST);
  return smaller;
}

SmallImages reduce(const cv::Mat& color_bgr, const cv::Mat& depth_m, const core::DepthNoise& depthNoise,
                   const cv::Mat& instanceIds) {
  constexpr double kColumns = 320.0;
  SmallImages small;
  small.depthNoise = depthNoise;
  small.step = std::max(1, static_cast<int>(std::lround(color_bgr.cols / kColumns)));
  small.inverseDepth = inverseDepth(everyNth(depth_m, small.step));
  small.color_bgr = everyNth(color_bgr, small.step);
  small.instanceIds = everyNth(instanceIds, small.step);
  return small;
}

cv::Rect widened(const cv::Rect& box, int margin_px, const cv::Size& image) {
  const cv::Rect wider(box.x - margin_px, box.y - margin_px, box.width + 2 * margin_px, box.height + 2 * margin_px);
  return wider & cv::Rect({}, image);
}

/// In the middle of the thing, in 1/m; 0 where too little of it has depth. Every second row tells enough.
float medianInverseDepth(const cv::Mat& inverseDepth, const cv::Mat& mask) {
  std::vector<float> values;
  int inside_px = 0;
  for (int y = 0; y < mask.rows; y += 2) {
    const auto* isIn = mask.ptr<std::uint8_t>(y);
    const auto* w = inverseDepth.ptr<float>(y);
    for (int x = 0; x < mask.cols; ++x) {
      if (isIn[x] == 0) continue;
      ++inside_px;
      if (w[x] > 0) values.push_back(w[x]);
    }
  }
  if (values.empty() || static_cast<double>(values.size()) < kMinDepthShare * inside_px) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Carries what changed in the small image (`box` of it) over to the segmentation.
void transfer(const cv::Mat& found, const cv::Mat& refined, const cv::Rect& box, int step, core::Instance& instance,
              core::Segmentation& segmentation) {
  const cv::Rect area(box.tl() * step, box.size() * step);
  const auto enlarged = [&](const cv::Mat& small) {
    cv::Mat large;
    cv::resize(small, large, area.size(), 0, 0, cv::INTER_NEAREST);
    return large;
  };
  cv::Mat ids = segmentation.instanceIds(area);
  cv::Mat classes = segmentation.classIds(area);
  const cv::Mat lost = enlarged(found & ~refined) & (ids == instance.id);
  const cv::Mat gained = enlarged(refined & ~found) & (ids == 0);
  ids.setTo(0, lost);
  classes.setTo(0, lost);
  ids.setTo(instance.id, gained);
  classes.setTo(instance.classId, gained);
  const cv::Rect extent = (area | instance.box_px) & cv::Rect({}, segmentation.instanceIds.size());
  instance.box_px = cv::boundingRect(segmentation.instanceIds(extent) == instance.id) + extent.tl();
}

void refineInstance(const ContourOptions& options, SmallImages& small, core::Instance& instance,
                    core::Segmentation& segmentation) {
  const cv::Rect extent = cv::boundingRect(small.instanceIds == instance.id);
  if (extent.empty()) return;
  const cv::Rect box = widened(extent, kSurroundings_px, small.instanceIds.size());
  cv::Mat ids = small.instanceIds(box);
  InstanceCrop view;
  view.inverseDepth = small.inverseDepth(box);
  view.depthNoise = small.depthNoise;
  view.color_bgr = small.color_bgr(box);
  view.mask = ids == instance.id;
  view.isFree = ids == 0;
  view.medianInverseDepth = medianInverseDepth(view.inverseDepth, view.mask);
  view.maxGrowth_px = options.max_growth_px / small.step;
  if (!(view.medianInverseDepth > 0)) return;

  const cv::Mat refined = InstanceContour(view, options).refined();
  if (cv::countNonZero(refined & view.mask) < kMinKept * cv::countNonZero(view.mask)) return;
  transfer(view.mask, refined, box, small.step, instance, segmentation);
  ids.setTo(0, view.mask);
  ids.setTo(instance.id, refined);
}

bool hasAnyOf(const ContourRefiner::ClassSet& classes, const std::vector<core::Instance>& instances) {
  return std::any_of(instances.begin(), instances.end(),
                     [&](const core::Instance& instance) { return classes[instance.classId]; });
}

}  // namespace

core::Segmentation ContourRefiner::refine(const cv::Mat& color_bgr, const cv::Mat& depth_m,
                                          const core::DepthNoise& depthNoise, const core::Segmentation& found) const {
  const cv::Size size = found.classIds.size();
  const bool fits = found.instanceIds.size() == size && depth_m.size() == size && color_bgr.size() == size;
  if (size.empty() || !fits || !hasAnyOf(classes_, found.instances)) return found;
  core::Segmentation refined = {found.classIds.clone(), found.instanceIds.clone(), found.instances};
  SmallImages small = reduce(color_bgr, depth_m, depthNoise, found.instanceIds);
  for (core::Instance& instance : refined.instances) {
    if (classes_[instance.classId]) refineInstance(options_, small, instance, refined);
  }
  return refined;
}

}  // namespace wardslam::masks
