#include "blanking.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include "wardslam/core/nearest_pixel.h"
#include "wardslam/core/people.h"

namespace wardslam::rawlog_annotate {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using mrpt_plugin::CObservationSemanticRGBD;

cv::Mat peopleIn(const CObservationSemanticRGBD& semantic, const cv::Size& size) {
  const bool isLookedFor = !semantic.segmentation.empty() && !semantic.labelBits.empty();
  return isLookedFor ? core::peoplePixels(semantic.labelBits) : cv::Mat(size, CV_8UC1, cv::Scalar(255));
}

void blankDepth(mrpt::math::CMatrix_u16& depth, const cv::Mat& people) {
  if (depth.rows() != people.rows || depth.cols() != people.cols) return;
  for (int row = 0; row < people.rows; ++row) {
    for (int col = 0; col < people.cols; ++col) {
      if (people.at<std::uint8_t>(row, col) != 0) depth(row, col) = 0;
    }
  }
}

void blankDepth(CObservation3DRangeScan& scan, const cv::Mat& people) {
  if (scan.hasPoints3D) scan.resizePoints3DVectors(0);  // whoever wants points makes them of the depth
  scan.hasPoints3D = false;
  if (!scan.hasRangeImage || !scan.doDepthAndIntensityCamerasCoincide()) return;
  if (scan.rangeImage_isExternallyStored()) scan.rangeImage_forceResetExternalStorage();
  blankDepth(scan.rangeImage, people);
  for (auto& [name, layer] : scan.rangeImageOtherLayers) blankDepth(layer, people);
}

void removeKeypoints(CObservationSemanticRGBD& semantic, const cv::Mat& people) {
  const core::Features all = semantic.features;
  const auto states = semantic.states;
  semantic.features.keypoints.clear();
  semantic.features.descriptors = cv::Mat(0, all.descriptors.cols, all.descriptors.type());
  semantic.states.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const cv::Point pixel = core::nearestPixel(all.keypoints[i].raw_px, people.size());
    if (people.at<std::uint8_t>(pixel) != 0) continue;
    semantic.features.keypoints.push_back(all.keypoints[i]);
    semantic.features.descriptors.push_back(all.descriptors.row(static_cast<int>(i)));
    semantic.states.push_back(states[i]);
  }
}

}  // namespace

void blankPeople(CObservation3DRangeScan& scan, CObservationSemanticRGBD& semantic) {
  const cv::Mat color = scan.intensityImage.asCvMat<cv::Mat>(mrpt::img::SHALLOW_COPY);
  const cv::Mat people = peopleIn(semantic, color.size());
  scan.intensityImage = mrpt::img::CImage(core::blanked(color, people), mrpt::img::DEEP_COPY);
  blankDepth(scan, people);
  removeKeypoints(semantic, people);
}

}  // namespace wardslam::rawlog_annotate
