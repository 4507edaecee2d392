#include "wardslam/segmentation/stamped_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class StampedFilesTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string nearest(double stamp_s, double tolerance_s) const {
    const auto file = StampedFiles(folder_.path(), ".png").nearest(stamp_s, tolerance_s);
    return file ? file->filename().string() : "none";
  }

  test::TemporaryFolder folder_;
};

TEST_F(StampedFilesTest, FindsEachStampExactly) {
  for (const char* name : {"1305031234.329654.png", "1305031234.293697.png", "1305031234.361612.png"}) {
    folder_.write(name, "");
  }
  EXPECT_EQ(nearest(1305031234.293697, 0.0), "1305031234.293697.png");
  EXPECT_EQ(nearest(1305031234.329654, 0.0), "1305031234.329654.png");
  EXPECT_EQ(nearest(1305031234.361612, 0.0), "1305031234.361612.png");
  EXPECT_EQ(nearest(1305031234.361614, 0.0), "none");
}

TEST_F(StampedFilesTest, FindsTheNearestWithinTheTolerance) {
  folder_.write("10.000000.png", "");
  folder_.write("10.033333.png", "");
  EXPECT_EQ(nearest(10.005, 0.005), "10.000000.png");
  EXPECT_EQ(nearest(10.005001, 0.005), "none");
  EXPECT_EQ(nearest(9.995, 0.005), "10.000000.png");
  EXPECT_EQ(nearest(9.994, 0.005), "none");
  EXPECT_EQ(nearest(10.038, 0.005), "10.033333.png");
  EXPECT_EQ(nearest(10.039, 0.005), "none");
  EXPECT_EQ(nearest(10.018, 1.0), "10.033333.png");
  EXPECT_EQ(nearest(10.016, 1.0), "10.000000.png");
}

TEST_F(StampedFilesTest, KeepsOnlyStampsOfTheExtension) {
  for (const char* name : {"2.5.PNG", "1.5.png", "3.5.jpg", "preview.png", "4.5_old.png", "nan.png"}) {
    folder_.write(name, "");
  }
  const StampedFiles files(folder_.path(), ".png");
  EXPECT_EQ(files.size(), 2U);
  EXPECT_DOUBLE_EQ(files.firstStamp_s(), 1.5);
  EXPECT_DOUBLE_EQ(files.lastStamp_s(), 2.5);
  EXPECT_EQ(files.firstFile().filename(), "1.5.png");
}

TEST_F(StampedFilesTest, ReadsOtherClocksAndSpellings) {
  const auto expectFound = [&](const std::string& name, double stamp_s) {
    const test::TemporaryFolder folder;
    folder.write(name, "");
    EXPECT_TRUE(StampedFiles(folder.path(), ".png").nearest(stamp_s, 1e-5)) << name;
  };
  expectFound("1700000003333333000.png", 1700000003.333333);
  expectFound("1700000003333333.png", 1700000003.333333);
  expectFound("1700000003_333333.png", 1700000003.333333);
  expectFound("1700000003.333333.jpg.png", 1700000003.333333);
}

TEST_F(StampedFilesTest, RefusesMissingAndEmptyFolders) {
  const auto open = [](const std::filesystem::path& folder) { const StampedFiles files(folder, ".png"); };
  const auto missing = folder_.path() / "missing";
  EXPECT_THAT([&] { open(missing); }, ::testing::ThrowsMessage<core::InputError>(
                                          AllOf(HasSubstr(missing.string()), HasSubstr("No such file"))));
  folder_.write("preview.png", "");
  EXPECT_THAT([&] { open(folder_.path()); }, ::testing::ThrowsMessage<core::InputError>(AllOf(
                                                 HasSubstr(folder_.path().string()), HasSubstr("named by the stamp"))));
}

}  // namespace
}  // namespace wardslam::segmentation
