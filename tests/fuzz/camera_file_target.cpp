#include "fuzz_input.h"
#include "wardslam/sources/rgbd_camera.h"

// Camera files: ours and those of all programs that are read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = wardslam::fuzz::scratch().write("camera.yaml", data, size);
  wardslam::fuzz::mayRefuse([&] { (void)wardslam::sources::readRgbdCamera(file); });
  return 0;
}
