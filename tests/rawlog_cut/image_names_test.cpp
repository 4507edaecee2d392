#include "image_names.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>

#include "support/temporary_folder.h"

namespace wardslam::rawlog_cut {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::uint8_t> bytesOf(const mrpt::serialization::CSerializable& object) {
  std::vector<std::uint8_t> bytes;
  mrpt::serialization::ObjectToOctetVector(&object, bytes);
  return bytes;
}

TEST(ImageNames, AreThoseTheObjectsName) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a_INT.png", "b_INT.png", "c.png", "sub/d.png"}) folder.write(name, "image");
  ImageNames names(folder.path());

  mrpt::obs::CObservation3DRangeScan scan;
  scan.hasIntensityImage = true;
  scan.intensityImage.setExternalStorage("b_INT.png");
  names.lookIn(bytesOf(scan));
  EXPECT_THAT(names.named(), ElementsAre("b_INT.png"));

  mrpt::obs::CObservationImage image;
  image.image.setExternalStorage("sub/d.png");
  names.lookIn(bytesOf(image));
  EXPECT_THAT(names.named(), ElementsAre("b_INT.png", "sub/d.png"));
}

TEST(ImageNames, AreNotFoundInOtherText) {
  const test::TemporaryFolder folder;
  folder.write("c.png", "image");
  ImageNames names(folder.path());
  names.lookIn({});
  names.lookIn({5, 0, 0});
  names.lookIn({5, 0, 0, 0, 'c', '.', 'p', 'n'});               // ends early
  names.lookIn({6, 0, 0, 0, 'c', '.', 'p', 'n', 'g', '2'});     // another name
  names.lookIn({255, 255, 255, 255, 'c', '.', 'p', 'n', 'g'});  // no length
  EXPECT_THAT(names.named(), IsEmpty());
  names.lookIn({9, 5, 0, 0, 0, 'c', '.', 'p', 'n', 'g', 1});
  EXPECT_THAT(names.named(), ElementsAre("c.png"));
}

}  // namespace
}  // namespace wardslam::rawlog_cut
