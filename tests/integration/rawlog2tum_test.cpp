#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>

#include "cli_test_support.h"
#include "recording/rawlog_writer.h"
#include "sources/scan_maker.h"
#include "sources/tum_folder_writer.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Rawlog2Tum : public ::testing::Test {
 protected:
  void convertThere(const fs::path& from, const fs::path& file) const {
    ASSERT_EQ(test::runProgram("tum2rawlog", {from.string(), "-o", file.string()}).exitCode, 0);
  }
  [[nodiscard]] test::CommandResult convertBack(const fs::path& file, const fs::path& to) const {
    return test::runProgram("rawlog2tum", {file.string(), "-o", to.string()});
  }

  /// Equal to the bit.
  static void expectSameImage(const fs::path& a, const fs::path& b) {
    const cv::Mat left = cv::imread(a.string(), cv::IMREAD_UNCHANGED);
    const cv::Mat right = cv::imread(b.string(), cv::IMREAD_UNCHANGED);
    ASSERT_FALSE(left.empty()) << a;
    ASSERT_EQ(left.type(), right.type()) << b;
    ASSERT_EQ(left.size(), right.size()) << b;
    EXPECT_TRUE(std::equal(left.datastart, left.dataend, right.datastart)) << b;
  }

  /// What is not a comment.
  static std::string linesOf(const fs::path& list) {
    std::istringstream text(test::readText(list));
    std::string lines;
    for (std::string line; std::getline(text, line);) {
      if (line.front() != '#') lines += line + "\n";
    }
    return lines;
  }

  test::TemporaryFolder folder;
  fs::path rawlog = folder.path() / "there.rawlog";
  fs::path back = folder.path() / "back";
};

TEST_F(Rawlog2Tum, GivesBackImagesStampsAndTruth) {
  const test::TumFolder sequence(3);
  sequence.write("groundtruth.txt", "# truth\n100.0000 1 2 3 0 0 0 1\n");
  cv::Mat noise(test::TumFolder::kHeight_px, test::TumFolder::kWidth_px, CV_16UC1);
  cv::randu(noise, 0, 65535);  // every digit of the depth counts, 0 as well; 65535 is no measurement
  noise.at<std::uint16_t>(0, 0) = 65534;
  sequence.writeImage(test::TumFolder::depthFile(1), noise);
  convertThere(sequence.path(), rawlog);
  const auto result = convertBack(rawlog, back);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out, back.string() + ": 3 image pairs\n");

  for (int i = 0; i < 3; ++i) {
    for (const auto& name : {test::TumFolder::colorFile(i), test::TumFolder::depthFile(i)}) {
      expectSameImage(sequence.path() / name, back / name);
    }
  }
  for (const char* list : {"rgb.txt", "depth.txt"}) EXPECT_EQ(linesOf(back / list), linesOf(sequence.path() / list));
  EXPECT_EQ(test::readText(back / "groundtruth.txt"), test::readText(sequence.path() / "groundtruth.txt"));
}

TEST_F(Rawlog2Tum, ASecondTripChangesNotOneByte) {
  const test::TumFolder sequence(2);
  convertThere(sequence.path(), rawlog);
  ASSERT_EQ(convertBack(rawlog, back).exitCode, 0);
  const fs::path again = folder.path() / "again.rawlog";
  const fs::path twice = folder.path() / "twice";
  convertThere(back, again);
  ASSERT_EQ(convertBack(again, twice).exitCode, 0);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(back)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    EXPECT_EQ(test::readText(twice / fs::relative(entry.path(), back)), test::readText(entry.path())) << entry.path();
  }
  EXPECT_EQ(files, 2U * 2 + 3 + 1);  // images, lists, camera.yaml
}

TEST_F(Rawlog2Tum, NamesImagesByTheirStampsWhereNothingElseIsKnown) {
  recording::RawlogWriter writer(rawlog);
  writer.write(*test::makeScan(0, 32, 24));  // in millimetres
  writer.write(*test::makeScan(1, 32, 24));
  writer.commit();
  EXPECT_EQ(convertBack(rawlog, back).exitCode, 0);
  EXPECT_EQ(linesOf(back / "rgb.txt"), "1000.000000 rgb/1000.000000.png\n1001.000000 rgb/1001.000000.png\n");
  EXPECT_THAT(test::readText(back / "camera.yaml"), HasSubstr("depth_factor: 1000 "));
  const cv::Mat depth = cv::imread((back / "depth/1001.000000.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_16UC1);
  EXPECT_EQ(depth.at<std::uint16_t>(2, 3), 1000 + 2 * 8 + 3 + 1);
}

TEST_F(Rawlog2Tum, KeepsWhatIsThere) {
  recording::RawlogWriter writer(rawlog);
  writer.write(*test::makeScan());
  writer.commit();
  folder.write("back/mine.txt", "mine");
  const auto result = convertBack(rawlog, back);
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("is there already"));
  EXPECT_EQ(test::readText(back / "mine.txt"), "mine");
}

TEST_F(Rawlog2Tum, LeavesNothingBehindOfWhatIsNoRawlog) {
  folder.write("there.rawlog", "no rawlog");
  const auto result = convertBack(rawlog, back);
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("not a rawlog"));
  EXPECT_EQ(convertBack(folder.path() / "none.rawlog", back).exitCode, 1);
  fs::remove(rawlog);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace wardslam
