#include "instance_painter.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace wardslam::segmentation {

cv::Rect roundedWithin(const cv::Rect2d& box_px, const cv::Size& image_px) {
  // Clamped before the conversion to integers, which a wild box would overflow.
  const auto edge = [](double value, int limit) { return cvRound(std::clamp(value, 0.0, static_cast<double>(limit))); };
  return {cv::Point(edge(box_px.x, image_px.width), edge(box_px.y, image_px.height)),
          cv::Point(edge(box_px.x + box_px.width, image_px.width), edge(box_px.y + box_px.height, image_px.height))};
}

cv::Mat thresholdResampled(const cv::Mat& values, const cv::Size& size_px, const cv::Point2d& scale,
                           const cv::Point2d& offset, double threshold) {
  // warpAffine takes pixel centres for whole numbers.
  const cv::Matx23d toValues(scale.x, 0.0, 0.5 * scale.x + offset.x - 0.5, 0.0, scale.y,
                             0.5 * scale.y + offset.y - 0.5);
  cv::Mat resampled;
  cv::warpAffine(values, resampled, toValues, size_px, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  return resampled > threshold;
}

InstancePainter::InstancePainter(const cv::Size& image_px) {
  segmentation_.classIds = cv::Mat(image_px, CV_8UC1, cv::Scalar(0));
  segmentation_.instanceIds = cv::Mat(image_px, CV_16UC1, cv::Scalar(0));
}

void InstancePainter::paint(core::ClassId classId, float confidence, const cv::Rect& box_px, cv::Mat mask) {
  cv::Mat instanceIds = segmentation_.instanceIds(box_px);
  mask &= instanceIds == 0;
  if (cv::countNonZero(mask) == 0) return;
  const auto id = static_cast<std::uint16_t>(segmentation_.instances.size() + 1);
  instanceIds.setTo(id, mask);
  segmentation_.classIds(box_px).setTo(classId, mask);
  segmentation_.instances.push_back({id, classId, std::min(confidence, 1.0F), box_px});
}

}  // namespace wardslam::segmentation
