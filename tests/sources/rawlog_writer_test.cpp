#include "wardslam/sources/rawlog_writer.h"

#include <gmock/gmock.h>

#include "sources/scan_maker.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/rawlog_source.h"

namespace wardslam::sources {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class WrittenRawlog : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "out.rawlog";
};

TEST_F(WrittenRawlog, KeepsColoursExactly) {
  const auto scan = test::makeScan();
  {
    RawlogWriter writer(file);
    writer.write(*scan);
    EXPECT_FALSE(std::filesystem::exists(file));  // not before it is complete
    writer.commit();
  }
  RawlogSource source(file, {});
  EXPECT_EQ(cv::norm(source.next()->intensityImage.asCvMatRef(), scan->intensityImage.asCvMatRef(), cv::NORM_INF), 0.0);
  EXPECT_FALSE(source.next());
}

TEST_F(WrittenRawlog, IsAbsentWhenGivenUp) {
  {
    RawlogWriter writer(file);
    writer.write(*test::makeScan());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(WrittenRawlog, CannotBeCreatedInAMissingFolder) {
  EXPECT_THAT([&] { RawlogWriter(folder.path() / "none" / "out.rawlog"); },
              ThrowsMessage<core::InputError>(HasSubstr("cannot be created")));
}

TEST_F(WrittenRawlog, CannotReplaceAFolder) {
  std::filesystem::create_directory(file);
  EXPECT_THAT([&] { RawlogWriter writer(file); }, ThrowsMessage<core::InputError>(HasSubstr("no file")));
  EXPECT_TRUE(std::filesystem::is_directory(file));
}

TEST_F(WrittenRawlog, ReplacesAFile) {
  folder.write("out.rawlog", "something else");
  RawlogWriter writer(file);
  writer.write(*test::makeScan());
  writer.commit();
  EXPECT_TRUE(RawlogSource(file, {}).next());
}

}  // namespace
}  // namespace wardslam::sources
