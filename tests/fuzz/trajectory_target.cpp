#include <cmath>
#include <cstdlib>

#include "fuzz_input.h"
#include "wardslam/exchange/tum_trajectory.h"

// Trajectories of the TUM benchmark and of other programs; what is read is finite and in order.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto file = fuzz::scratch().write("trajectory.txt", data, size);
  fuzz::mayRefuse([&] {
    double last_s = -INFINITY;
    for (const core::StampedPose& pose : exchange::readTumTrajectory(file)) {
      if (!(pose.stamp_s > last_s) || !pose.T_map_cam.matrix().allFinite()) std::abort();
      last_s = pose.stamp_s;
    }
  });
  fuzz::mayRefuse([&] { (void)exchange::readTumTrajectory(file, {[](const std::string&) {}, 30.0}); });
  fuzz::mayRefuse([&] { (void)exchange::readTumStamps(file); });
  fuzz::mayRefuse([&] { (void)exchange::numbersImages(file); });
  return 0;
}
