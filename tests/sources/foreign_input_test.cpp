#include "foreign_input.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class ForeignInput : public ::testing::Test {
 protected:
  void expectRefused(const std::string& name, const std::string& bytes, const std::string& kind,
                     const std::string& advice) const {
    const auto file = folder.write(name, bytes + std::string(1000, '\0'));
    EXPECT_THAT([&] { refuseForeignInput(file); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr(name), HasSubstr(kind), HasSubstr(advice))));
  }
  test::TemporaryFolder folder;
};

TEST_F(ForeignInput, IsNamedByItsFirstBytes) {
  expectRefused("a.wardmap", "SQLite format 3", "a map", "--map");
  expectRefused("a", "PK\x03\x04", "zip", "unpack");
  expectRefused("a", "BZh91AY", "bzip2", "unpack");
  expectRefused("a.klg", "\x02", "Logger2", "export");
  expectRefused("a.sens", "\x04", "ScanNet", "export");
  expectRefused("a", "NI10", "OpenNI", "export");
  expectRefused("a.mp4", std::string("\0\0\0\x20", 4) + "ftypisom", "a video", "export");
  expectRefused("a", "# .PCD v0.7", "point cloud", "TUM");
}

TEST_F(ForeignInput, IsATarArchiveCompressedOrNot) {
  std::string tar(512, '\0');
  tar.replace(257, 5, "ustar");
  expectRefused("rgbd_dataset_freiburg1_desk", tar, "tar archive", "tar xf rgbd_dataset_freiburg1_desk");
  const auto file = folder.path() / "seq.tgz";
  gzFile gz = gzopen(file.c_str(), "wb");
  gzwrite(gz, tar.data(), static_cast<unsigned>(tar.size()));
  gzclose(gz);
  EXPECT_THAT([&] { refuseForeignInput(file); }, ThrowsMessage<core::InputError>(HasSubstr("tar archive")));
}

// Plain ones are no foreign input.
TEST_F(ForeignInput, IsABagThatIsPackedAsAWhole) {
  const auto file = folder.path() / "ward.bag.gz";
  gzFile gz = gzopen(file.c_str(), "wb");
  gzwrite(gz, "#ROSBAG V2.0\n", 13);
  gzclose(gz);
  EXPECT_THAT([&] { refuseForeignInput(file); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("bag of ROS 1"), HasSubstr("gunzip"))));
}

TEST_F(ForeignInput, IsNotWhatCouldBeARawlog) {
  EXPECT_NO_THROW(refuseForeignInput(folder.write("short", "ab")));
  EXPECT_NO_THROW(refuseForeignInput(folder.write("a.rawlog", "")));
  EXPECT_NO_THROW(refuseForeignInput(folder.write("b.rawlog", "\x95mrpt::obs::CObservation")));
}

}  // namespace
}  // namespace wardslam::sources
