#include "fuzz_input.h"
#include "ros_messages.h"

// One message of ROS: the first byte says how it is serialised, the rest is it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  if (size == 0) return 0;
  const bags::Bytes message(data + 1, data + size);
  fuzz::readAsAll(message, data[0] % 2 == 0 ? bags::Wire::Ros1 : bags::Wire::Cdr);
  return 0;
}
