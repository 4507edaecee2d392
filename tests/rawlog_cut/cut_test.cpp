#include "cut.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <functional>

#include "recording/rawlog_writer.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/rawlog_reader.h"

namespace wardslam::rawlog_cut {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservationImage;
using mrpt::obs::CObservationOdometry;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using Objects = std::vector<std::vector<std::uint8_t>>;

constexpr double kBegin_s = 1700000000.0;

std::shared_ptr<CObservationImage> image(double stamp_s, const std::string& file = "") {
  auto one = std::make_shared<CObservationImage>();
  one->sensorLabel = "camera";
  one->timestamp = core::toMrptTime(stamp_s);
  if (file.empty()) one->image.resize(8, 6, mrpt::img::CH_RGB);
  if (!file.empty()) one->image.setExternalStorage(file);
  return one;
}

std::shared_ptr<CObservationOdometry> odometry(double stamp_s) {
  auto one = std::make_shared<CObservationOdometry>();
  one->sensorLabel = "wheels";
  one->timestamp = core::toMrptTime(stamp_s);
  return one;
}

class RawlogCut : public ::testing::Test {
 protected:
  /// A comment, then a reading of the wheels and an image every second.
  void record(int seconds = 5) const {
    recording::RawlogWriter writer(input);
    mrpt::obs::CObservationComment comment;
    comment.text = "a ward";
    writer.write(comment);
    for (int i = 0; i < seconds; ++i) {
      writer.write(*odometry(kBegin_s + i));
      writer.write(*image(kBegin_s + i));
    }
    writer.commit();
  }

  [[nodiscard]] CutReport cut(const Selection& selection) const {
    return cutRawlog({input, output, selection}, apps::InterruptionGuard());
  }
  [[nodiscard]] std::string complaint(const Selection& selection) const {
    try {
      static_cast<void>(cut(selection));
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] CutReport cutWithout(const std::string& label) const {
    Selection selection;
    selection.remove = {label};
    return cut(selection);
  }

  static Objects read(const fs::path& file) {
    sources::RawlogReader reader(file);
    Objects objects;
    while (reader.read()) objects.push_back(reader.bytes());
    return objects;
  }

  /// Nothing was left behind but the input.
  void expectNothingWritten() const {
    for (const auto& entry : fs::directory_iterator(folder.path())) EXPECT_EQ(entry.path(), input);
  }

  test::TemporaryFolder folder;
  fs::path input = folder.path() / "in.rawlog";
  fs::path output = folder.path() / "out.rawlog";
};

TEST_F(RawlogCut, ACameraThatIsRemovedIsGone) {
  record();
  const CutReport report = cutWithout("camera");
  EXPECT_THAT(report.read.observations, ElementsAre(Pair("camera", 5), Pair("wheels", 5)));
  EXPECT_THAT(report.written.observations, ElementsAre(Pair("wheels", 5)));
  EXPECT_EQ(report.read.objects, 11U);
  EXPECT_EQ(report.written.objects, 6U);
  EXPECT_EQ(report.trouble, "");

  const Objects before = read(input);
  EXPECT_EQ(read(output), (Objects{before[0], before[1], before[3], before[5], before[7], before[9]}));
}

TEST_F(RawlogCut, KeepsASpanOfTimeByteForByte) {
  record();
  Selection selection;
  selection.from = Moment::parse("+1");
  selection.to = Moment::parse("1700000002");
  EXPECT_THAT(cut(selection).written.observations, ElementsAre(Pair("camera", 2), Pair("wheels", 2)));
  const Objects before = read(input);
  EXPECT_EQ(read(output), (Objects{before[0], before[3], before[4], before[5], before[6]}));
}

TEST_F(RawlogCut, ReachesIntoSensoryFrames) {
  mrpt::obs::CSensoryFrame frame;
  frame.insert(odometry(kBegin_s));
  frame.insert(image(kBegin_s));
  recording::RawlogWriter writer(input);
  writer.write(frame);
  writer.commit();
  EXPECT_THAT(cutWithout("camera").written.observations, ElementsAre(Pair("wheels", 1)));
  sources::RawlogReader reader(output);
  const auto left = sources::observationsIn(reader.read());
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0]->sensorLabel, "wheels");
}

TEST_F(RawlogCut, TakesAlongTheExternalImagesThatAreLeftAndNoOthers) {
  fs::create_directory(folder.path() / "in_Images");
  recording::RawlogWriter writer(input);
  for (int i = 0; i < 3; ++i) {
    const std::string name = "camera_" + std::to_string(i) + ".png";
    folder.write("in_Images/" + name, std::to_string(i));
    writer.write(*odometry(kBegin_s + i));
    writer.write(*image(kBegin_s + i, name));
  }
  writer.commit();
  Selection selection;
  selection.to = Moment::parse("+1");
  static_cast<void>(cut(selection));
  const fs::path images = folder.path() / "out_Images";
  EXPECT_EQ(test::readText(images / "camera_0.png"), "0");
  EXPECT_EQ(test::readText(images / "camera_1.png"), "1");
  EXPECT_FALSE(fs::exists(images / "camera_2.png"));
  EXPECT_FALSE(fs::is_symlink(images));

  EXPECT_THAT(complaint(selection), HasSubstr("out_Images: is there already"));
  output = folder.path() / "blind.rawlog";
  static_cast<void>(cutWithout("camera"));
  EXPECT_FALSE(fs::exists(folder.path() / "blind_Images"));
}

TEST_F(RawlogCut, TellsOfALabelThatDoesNotOccur) {
  record();
  Selection selection;
  selection.remove = {"camra"};
  EXPECT_THAT(complaint(selection), HasSubstr("no sensor is labelled 'camra'; its labels are 'camera', 'wheels'"));
  expectNothingWritten();
}

TEST_F(RawlogCut, WritesNothingWhereNothingWouldBeLeft) {
  record();
  Selection selection;
  selection.from = Moment::parse("+100");
  EXPECT_THAT(complaint(selection), HasSubstr("no observation of it would be left"));
  expectNothingWritten();
}

TEST_F(RawlogCut, NeverWritesOverItsInput) {
  record();
  const std::string before = test::readText(input);
  output = input;
  Selection selection;
  selection.remove = {"camera"};
  EXPECT_THAT(complaint(selection), HasSubstr("is the input"));
  EXPECT_EQ(test::readText(input), before);
}

TEST_F(RawlogCut, CutsTheSoundPartOfARawlogThatIsCutOff) {
  record(200);
  fs::resize_file(input, fs::file_size(input) / 2);
  const CutReport report = cutWithout("camera");
  EXPECT_THAT(report.trouble, HasSubstr("is cut off or damaged"));
  EXPECT_GT(report.written.observations.at("wheels"), 10U);
  EXPECT_EQ(read(output).size(), report.written.objects);
}

TEST_F(RawlogCut, RefusesWhatIsBehindAClassItDoesNotKnow) {
  record(1);
  recording::RawlogWriter writer(folder.path() / "more.rawlog");
  for (const auto& object : read(input)) writer.write(object);
  // "CObservationOdometry" of somebody else's.
  auto foreign = read(input).at(1);
  const std::string name = "CObservationOdometry";
  const auto at = std::search(foreign.begin(), foreign.end(), name.begin(), name.end());
  ASSERT_NE(at, foreign.end());
  *at = 'X';
  writer.write(foreign);
  writer.commit();
  fs::rename(folder.path() / "more.rawlog", input);
  Selection selection;
  selection.remove = {"camera"};
  EXPECT_THAT(complaint(selection), HasSubstr("XObservationOdometry"));
  expectNothingWritten();
}

TEST_F(RawlogCut, TellsOfWhatIsNoRawlog) {
  folder.write("in.rawlog", "no rawlog");
  Selection selection;
  selection.remove = {"camera"};
  EXPECT_THAT(complaint(selection), HasSubstr("in.rawlog: "));
  expectNothingWritten();
}

/// What it reads back must be what was asked for.
class ReadBack : public RawlogCut {
 protected:
  [[nodiscard]] std::string complaintAbout(const Tally& written, const Selection& selection) const {
    Judge judge(selection);
    try {
      requireAsWritten(input, written, judge);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ReadBack, MustHoldWhatWasWrittenAndNothingElse) {
  record(2);
  Tally right;
  right.objects = 5;
  right.observations = {{"camera", 2}, {"wheels", 2}};
  EXPECT_EQ(complaintAbout(right, {}), "");

  Selection blind;
  blind.remove = {"camera"};
  EXPECT_THAT(complaintAbout(right, blind), HasSubstr("holds what was to be left out"));
  Tally more = right;
  more.objects = 6;
  EXPECT_THAT(complaintAbout(more, {}), HasSubstr("5 objects in place of 6"));
  Tally others = right;
  others.observations = {{"camera", 4}};
  EXPECT_THAT(complaintAbout(others, {}), HasSubstr("does not read back"));

  fs::resize_file(input, fs::file_size(input) - 20);
  EXPECT_THAT(complaintAbout(right, {}), HasSubstr("is cut off or damaged"));
}

}  // namespace
}  // namespace wardslam::rawlog_cut
