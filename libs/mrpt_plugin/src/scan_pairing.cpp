#include "scan_pairing.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/imgproc.hpp>
#include <utility>

#include "wardslam/core/annotation.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::mrpt_plugin {
namespace {

/// Of an image of another size than the colour image nobody knows which pixel is which.
bool fits(const cv::Mat& image, const core::Frame& frame) { return image.empty() || image.size() == frame.gray.size(); }

bool describes(const CObservationSemanticRGBD& semantic, const PlacedFrame& placed) {
  return core::fromMrptTime(semantic.timestamp) == placed.frame.stamp_s &&
         fits(semantic.segmentation.classIds, placed.frame) && fits(semantic.segmentation.instanceIds, placed.frame) &&
         fits(semantic.labelBits, placed.frame);
}

void add(const CObservationSemanticRGBD& semantic, PlacedFrame& placed) {
  placed.frame.segmentation = semantic.segmentation;
  placed.frame.labelBits = semantic.labelBits;
  placed.frame.mayMove = core::dynamicPixels(placed.frame);
  placed.classes = semantic.classes;
  placed.isAnnotated = true;
}

/// Annotations have the size of the range image.
void addAnnotation(PlacedFrame& placed, const mrpt::obs::CObservation3DRangeScan& scan) {
  cv::Mat bits = core::annotationOf(scan);
  if (bits.empty()) return;
  if (bits.size() != placed.frame.gray.size())
    cv::resize(bits, bits, placed.frame.gray.size(), 0, 0, cv::INTER_NEAREST);
  placed.frame.labelBits = bits;
  placed.frame.mayMove = core::dynamicPixels(placed.frame);
  placed.isAnnotated = true;
}

void load(const mrpt::obs::CObservation3DRangeScan& scan) {
  try {
    sources::loadImages(scan);
  } catch (const sources::InputDamage& damage) {
    throw core::FrameError(damage.what());
  }
}

}  // namespace

std::vector<PlacedFrame> ScanPairing::put(const mrpt::obs::CObservation3DRangeScan& scan,
                                          const Eigen::Isometry3d& T_map_base) {
  load(scan);
  PlacedFrame placed{frames_.build(std::make_shared<mrpt::obs::CObservation3DRangeScan>(scan)), T_map_base};
  placed.frame.observation = nullptr;
  placed.frame.color_bgr = placed.frame.color_bgr.clone();  // the image is the caller's
  addAnnotation(placed, scan);
  std::vector<PlacedFrame> complete;
  if (auto before = flush()) complete.push_back(std::move(*before));
  if (early_ && describes(*early_, placed)) {
    add(*early_, placed);
    complete.push_back(std::move(placed));
  } else {
    waiting_ = std::move(placed);
  }
  early_.reset();
  return complete;
}

std::optional<PlacedFrame> ScanPairing::put(const CObservationSemanticRGBD& semantic) {
  if (waiting_ && describes(semantic, *waiting_)) {
    add(semantic, *waiting_);
    return flush();
  }
  early_ = semantic;
  return std::nullopt;
}

std::optional<PlacedFrame> ScanPairing::flush() { return std::exchange(waiting_, std::nullopt); }

}  // namespace wardslam::mrpt_plugin
