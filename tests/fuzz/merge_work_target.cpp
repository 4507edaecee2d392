#include "fuzz_input.h"
#include "mapper_state_codec.h"

// What a merge that was ended has left, behind the checksum.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const core::Bytes bytes(data, data + size);
  fuzz::mayRefuse<core::BlobError>([&] {
    core::ByteReader in(bytes);
    (void)merging::getMapperState(in);
  });
  return 0;
}
