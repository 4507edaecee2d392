#include "fuzz_input.h"
#include "use_of_map.h"

// Map files whose bytes are anything: opened, checked, read and asked.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::filesystem::remove(wardslam::fuzz::scratch().path() / "map.wardmap-journal");
  const auto file = wardslam::fuzz::scratch().write("map.wardmap", data, size);
  wardslam::fuzz::mayRefuse([&] { wardslam::fuzz::useMap(file); });
  return 0;
}
