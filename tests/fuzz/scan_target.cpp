#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include "choices.h"
#include "fuzz_input.h"
#include "sources/scan_maker.h"
#include "stereo_depth.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/frame_builder.h"

namespace {

using namespace wardslam;

double number(fuzz::Choices& choices) {
  return choices.below(2) == 0 ? choices.take<double>() : choices.take<std::int16_t>() * 0.01;
}

void falsify(mrpt::img::TCamera& camera, fuzz::Choices& choices) {
  switch (choices.below(6)) {
    case 0:
      camera.fx(number(choices));
      break;
    case 1:
      camera.fy(number(choices));
      break;
    case 2:
      camera.cx(number(choices));
      break;
    case 3:
      camera.dist.at(choices.below(camera.dist.size())) = number(choices);
      camera.distortion = mrpt::img::DistortionModel::plumb_bob;
      break;
    case 4:
      camera.ncols = choices.take<std::uint32_t>();
      break;
    default:
      camera.nrows = choices.take<std::uint32_t>();
      break;
  }
}

void falsify(mrpt::poses::CPose3D& pose, fuzz::Choices& choices) {
  double values[6];
  for (double& value : values) value = choices.below(3) == 0 ? number(choices) : 0.0;
  pose = mrpt::poses::CPose3D(values[0], values[1], values[2], values[3], values[4], values[5]);
}

void falsify(mrpt::obs::CObservation3DRangeScan& scan, fuzz::Choices& choices) {
  switch (choices.below(6)) {
    case 0:
      falsify(scan.cameraParams, choices);
      break;
    case 1:
      falsify(scan.cameraParamsIntensity, choices);
      break;
    case 2:
      falsify(scan.relativePoseIntensityWRTDepth, choices);
      break;
    case 3:
      scan.rangeUnits = choices.take<float>();
      break;
    case 4:
      scan.range_is_depth = !scan.range_is_depth;
      break;
    default:
      scan.rangeImage_setSize(static_cast<int>(choices.below(20)), static_cast<int>(choices.below(20)));
      break;
  }
}

}  // namespace

// Observations of a rawlog or a driver whose parts do not fit, or are no numbers: a frame, or a core::FrameError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  const auto scan = test::makeScan();
  for (int i = 0; i < 6 && choices.areLeft(); ++i) falsify(*scan, choices);
  fuzz::mayRefuse<core::FrameError>([&] { (void)sources::FrameBuilder().build(scan); });

  mrpt::obs::CObservationStereoImages pair;
  pair.timestamp = scan->timestamp;
  pair.imageLeft = pair.imageRight = scan->intensityImage;
  pair.hasImageRight = true;
  pair.leftCamera = scan->cameraParams;
  pair.rightCamera = scan->cameraParamsIntensity;
  pair.rightCameraPose = mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(number(choices), number(choices), 0, 0, 0, 0));
  fuzz::mayRefuse<core::FrameError>([&] { (void)sources::StereoDepth({}).convert(pair); });
  return 0;
}
