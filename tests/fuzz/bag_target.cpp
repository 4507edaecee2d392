#include "fuzz_input.h"
#include "ros_messages.h"
#include "wardslam/bags/bag_reader.h"

// Recordings of ROS: bags of ROS 1, MCAP, SQLite; all of their messages.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  constexpr std::size_t kLookedAt = 64;
  const auto file = fuzz::scratch().write("recording.bag", data, size);
  if (!bags::isBag(file)) return 0;
  fuzz::mayRefuse([&] {
    const auto bag = bags::openBag(file);
    const auto& entries = bag->entries();
    for (std::size_t i = 0; i < entries.size() && i < kLookedAt; ++i) {
      fuzz::mayRefuse<bags::BagDamage>([&] { fuzz::readAsAll(bag->read(i), bag->topics().at(entries[i].topic).wire); });
    }
  });
  return 0;
}
