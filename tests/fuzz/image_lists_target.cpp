#include "fuzz_input.h"
#include "image_list_file.h"
#include "wardslam/sources/tum_lists.h"

// Lists of images: rgb.txt and depth.txt alike, and associations.txt.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto& folder = fuzz::scratch();
  fuzz::mayRefuse([&] {
    (void)folder.write("pair/rgb.txt", data, size);
    (void)folder.write("pair/depth.txt", data, size);
    (void)sources::listImagePairs(folder.path() / "pair");
  });
  fuzz::mayRefuse([&] {
    (void)folder.write("one/associations.txt", data, size);
    (void)sources::listImagePairs(folder.path() / "one");
  });
  return 0;
}
