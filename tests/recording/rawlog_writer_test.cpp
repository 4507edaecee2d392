#include "recording/rawlog_writer.h"

#include <gmock/gmock.h>

#include "sources/scan_maker.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::recording {
namespace {

using ::testing::ElementsAre;
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
  const auto source = sources::openSource(file, {});
  EXPECT_EQ(cv::norm(source->next()->intensityImage.asCvMatRef(), scan->intensityImage.asCvMatRef(), cv::NORM_INF),
            0.0);
  EXPECT_FALSE(source->next());
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
  EXPECT_TRUE(sources::openSource(file, {})->next());
}

/// Seconds of the stamps, 1000 taken off.
std::vector<int> numbersIn(const std::filesystem::path& file) {
  std::vector<int> numbers;
  const auto source = sources::openSource(file, {});
  while (const auto scan = source->next()) {
    numbers.push_back(static_cast<int>(core::fromMrptTime(scan->timestamp) + 0.5) - 1000);
  }
  EXPECT_TRUE(source->damage().empty());
  return numbers;
}

TEST_F(WrittenRawlog, GoesOnWhereAnInterruptedWriterWas) {
  std::uintmax_t checkpoint = 0;
  {
    RawlogWriter interrupted(file);
    interrupted.write(*test::makeScan(0));
    interrupted.write(*test::makeScan(1));
    checkpoint = interrupted.checkpoint();
    interrupted.write(*test::makeScan(2));  // lost
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  RawlogWriter next(file, ImageCoding::Lossless, checkpoint);
  next.write(*test::makeScan(3));
  EXPECT_GT(next.checkpoint(), checkpoint);
  next.write(*test::makeScan(4));
  next.commit();
  EXPECT_THAT(numbersIn(file), ElementsAre(0, 1, 3, 4));
}

TEST_F(WrittenRawlog, WhatIsDiscardedGoesAlsoBehindACheckpoint) {
  {
    RawlogWriter writer(file);
    writer.write(*test::makeScan());
    writer.checkpoint();
    writer.discard();
  }
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".partial"));
}

TEST_F(WrittenRawlog, CannotGoOnInAShorterFile) {
  {
    RawlogWriter interrupted(file);
    interrupted.write(*test::makeScan());
    interrupted.checkpoint();
  }
  EXPECT_THAT([&] { RawlogWriter(file, ImageCoding::Lossless, 1000000); },
              ThrowsMessage<core::InputError>(HasSubstr("shorter than it was")));
}

TEST_F(WrittenRawlog, BeginsAnewWhereNothingWasKept) {
  folder.write("out.rawlog.partial", "left by somebody else");
  RawlogWriter writer(file);
  writer.write(*test::makeScan(5));
  writer.commit();
  EXPECT_THAT(numbersIn(file), ElementsAre(5));
}

}  // namespace
}  // namespace wardslam::recording
