#include "fuzz_input.h"
#include "image_file.h"
#include "mask_file.h"
#include "wardslam/segmentation/instance_images.h"
#include "wardslam/sources/input_damage.h"

// Images of masks, depth and colour.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto file = fuzz::scratch().write("image.png", data, size);
  const auto mask = segmentation::readMaskFile(file);
  if (!mask.values.empty()) {
    cv::Mat ids = segmentation::labelRegions(mask.values, 1);
    (void)segmentation::listInstances(mask.values, ids);
  }
  (void)sources::isSixteenBitPng(file);
  fuzz::mayRefuse<sources::InputDamage>([&] { (void)sources::readDepthImage(file); });
  fuzz::mayRefuse<sources::InputDamage>([&] { (void)sources::readColorImage(file); });
  return 0;
}
