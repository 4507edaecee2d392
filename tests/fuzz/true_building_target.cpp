#include "fuzz_input.h"
#include "wardslam/evaluation/true_building.h"

// Rooms and doors as they were built, and what is made of them beside a floor plan.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto& folder = fuzz::scratch();
  fuzz::mayRefuse([&] {
    (void)folder.write("rooms.geojson", data, size);
    const auto truth = evaluation::readTrueBuilding(folder.path() / "rooms.geojson");
    mapping::FloorPlan plan;
    plan.resolution_m = 1.0;
    plan.cells = cv::Mat(5, 4, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
    building::Rooms found;
    found.all.resize(1);
    found.ids = cv::Mat(5, 4, CV_32SC1, cv::Scalar(1));
    (void)evaluation::evaluateRooms(truth, plan, found, Eigen::Isometry2d::Identity());
  });
  return 0;
}
