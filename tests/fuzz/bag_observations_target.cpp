#include <mrpt/obs/CObservation.h>

#include "fuzz_input.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/sources/bag_observations.h"
#include "wardslam/sources/choice_needed.h"
#include "wardslam/sources/observation_source.h"

// What a recording of ROS says about a camera and its robot.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto file = fuzz::scratch().write("recording.bag", data, size);
  if (!bags::isBag(file)) return 0;
  fuzz::mayRefuse([&] {
    sources::BagObservations bag(file, {});
    while (bag.next() != nullptr) continue;
  });
  return 0;
}
