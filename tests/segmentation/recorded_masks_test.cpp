#include "wardslam/segmentation/recorded_masks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::ThrowsMessage;
using ::testing::UnorderedElementsAre;

constexpr const char* kFirst = "1700000000.000000.png";
constexpr const char* kSecond = "1700000000.033333.png";
constexpr double kFirst_s = 1700000000.0;
constexpr double kSecond_s = 1700000000.033333;

class RecordedMasksTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(masks()); }

  [[nodiscard]] fs::path masks() const { return folder_.path() / "masks"; }

  /// A person on the left, a chair on the right.
  [[nodiscard]] static cv::Mat personAndChair() {
    cv::Mat image(48, 64, CV_8UC1, cv::Scalar(0));
    image(kPerson).setTo(1);
    image(kChair).setTo(57);
    return image;
  }

  void writeMask(const std::string& name, const cv::Mat& image) const {
    ASSERT_TRUE(cv::imwrite((masks() / name).string(), image));
  }
  void writeInstances(const std::string& name, const cv::Mat& image) const {
    fs::create_directories(folder_.path() / "instances");
    ASSERT_TRUE(cv::imwrite((folder_.path() / "instances" / name).string(), image));
  }

  [[nodiscard]] RecordedMasks open() const {
    RecordedMasksOptions options;
    options.folder = masks().string();
    return RecordedMasks(options);
  }

  inline static const cv::Rect kPerson{5, 10, 20, 30};
  inline static const cv::Rect kChair{40, 20, 15, 20};

  test::TemporaryFolder folder_;
  cv::Mat image_ = cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(0));
};

TEST_F(RecordedMasksTest, TakesInstancesFromTheSiblingFolder) {
  writeMask(kFirst, personAndChair());
  for (const int depth : {CV_8U, CV_16U}) {
    cv::Mat ids(48, 64, CV_MAKETYPE(depth, 1), cv::Scalar(0));
    ids(kPerson).setTo(7);
    ids(kChair).setTo(depth == CV_8U ? 9 : 900);
    writeInstances(kFirst, ids);

    const auto result = open().segment({image_, kFirst_s});
    EXPECT_THAT(result.events, IsEmpty());
    EXPECT_EQ(cv::norm(result.segmentation.classIds, personAndChair(), cv::NORM_INF), 0.0);
    EXPECT_EQ(result.segmentation.instanceIds.type(), CV_16UC1);
    ASSERT_EQ(result.segmentation.instances.size(), 2U);
    EXPECT_EQ(result.segmentation.instances[0].id, 7);
    EXPECT_EQ(result.segmentation.instances[0].classId, 1);
    EXPECT_EQ(result.segmentation.instances[0].box_px, kPerson);
    EXPECT_EQ(result.segmentation.instances[1].id, depth == CV_8U ? 9 : 900);
    EXPECT_EQ(result.segmentation.instances[1].classId, 57);
    EXPECT_EQ(result.segmentation.instances[1].box_px, kChair);
  }
}

TEST_F(RecordedMasksTest, TakesRegionsAsInstancesWithoutThatFolder) {
  cv::Mat mask = personAndChair();
  mask(cv::Rect(0, 0, 3, 3)).setTo(1);  // too small to be a thing
  writeMask(kFirst, mask);
  const auto result = open().segment({image_, kFirst_s});
  EXPECT_THAT(result.events, IsEmpty());
  ASSERT_EQ(result.segmentation.instances.size(), 2U);
  EXPECT_EQ(result.segmentation.instances[0].box_px, kPerson);
  EXPECT_EQ(result.segmentation.instances[1].box_px, kChair);
  EXPECT_EQ(result.segmentation.classIds.at<core::ClassId>(1, 1), 1);
  EXPECT_EQ(result.segmentation.instanceIds.at<std::uint16_t>(1, 1), 0);
}

TEST_F(RecordedMasksTest, FallsBackToRegionsWhereInstancesAreOfNoUse) {
  writeMask(kFirst, personAndChair());
  writeMask(kSecond, personAndChair());
  writeInstances(kSecond, cv::Mat(10, 10, CV_8UC1, cv::Scalar(1)));
  RecordedMasks masks = open();
  for (const double stamp_s : {kFirst_s, kSecond_s}) {
    const auto result = masks.segment({image_, stamp_s});
    EXPECT_THAT(result.events, UnorderedElementsAre(Pair("segmentation.instances_unreadable", 1U)));
    EXPECT_EQ(result.segmentation.instances.size(), 2U);
  }
}

TEST_F(RecordedMasksTest, NamesClassesFromTheSiblingFileOrTheOneGiven) {
  writeMask(kFirst, personAndChair());
  EXPECT_EQ(open().labelSpace().find("trolley"), std::nullopt);

  folder_.write("classes.txt", "102 trolley\n");
  EXPECT_EQ(open().labelSpace().find("trolley"), core::ClassId{102});
  EXPECT_EQ(open().labelSpace().find("person"), core::ClassId{1});

  RecordedMasksOptions options;
  options.folder = masks().string() + "/";  // a trailing slash does not change what lies beside
  EXPECT_EQ(RecordedMasks(options).labelSpace().find("trolley"), core::ClassId{102});
  const RecordedMasks other(options, folder_.write("other.txt", "103 iv_stand\n"));
  EXPECT_EQ(other.labelSpace().find("iv_stand"), core::ClassId{103});
  EXPECT_EQ(other.labelSpace().find("trolley"), std::nullopt);
}

TEST_F(RecordedMasksTest, CountsAMissingMaskAndGoesOn) {
  writeMask(kFirst, personAndChair());
  RecordedMasks masks = open();
  EXPECT_FALSE(masks.segment({image_, kFirst_s + 0.004}).segmentation.empty());
  for (int i = 0; i < 100; ++i) {
    const auto result = masks.segment({image_, kFirst_s + 1.0 + i});
    EXPECT_TRUE(result.segmentation.empty());
    EXPECT_THAT(result.events, UnorderedElementsAre(Pair("segmentation.mask_missing", 1U)));
  }
  EXPECT_NO_THROW(masks.finish());
}

TEST_F(RecordedMasksTest, GivesUpWhenTheFirstThirtyImagesMatchNothing) {
  writeMask(kFirst, personAndChair());
  writeMask(kSecond, personAndChair());
  RecordedMasks masks = open();
  for (int i = 0; i < 29; ++i) EXPECT_NO_THROW((void)masks.segment({image_, 1305031234.293697 + i}));
  EXPECT_THAT(
      [&] {
        (void)masks.segment({image_, 1305031999.0});
      },
      ThrowsMessage<core::InputError>(AllOf(HasSubstr(this->masks().string()), HasSubstr("1305031234.293697"),
                                            HasSubstr("1700000000.000000 to 1700000000.033333"), HasSubstr("5 ms"))));
}

TEST_F(RecordedMasksTest, ForgetsMissesOnceOneMatched) {
  writeMask(kFirst, personAndChair());
  RecordedMasks masks = open();
  for (int i = 0; i < 29; ++i) (void)masks.segment({image_, 1.0 + i});
  EXPECT_FALSE(masks.segment({image_, kFirst_s}).segmentation.empty());
  for (int i = 0; i < 29; ++i) EXPECT_NO_THROW((void)masks.segment({image_, 1.0 + i}));
}

TEST_F(RecordedMasksTest, TellsAtTheEndOfAShortRunThatNothingMatched) {
  writeMask(kFirst, personAndChair());
  RecordedMasks masks = open();
  EXPECT_NO_THROW(masks.finish());  // no image, nothing to complain about
  (void)masks.segment({image_, 12.5});
  EXPECT_THAT([&] { masks.finish(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("12.500000"), HasSubstr("no mask within"))));
}

TEST_F(RecordedMasksTest, SurvivesMasksThatCannotBeUsed) {
  writeMask(kFirst, personAndChair());
  const std::string whole = test::readText(masks() / kFirst);
  folder_.write("masks/1700000001.000000.png", whole.substr(0, whole.size() / 2));
  folder_.write("masks/1700000002.000000.png", "");
  folder_.write("masks/1700000003.000000.png", "not a picture");
  writeMask("1700000004.000000.png", cv::Mat(24, 32, CV_8UC1, cv::Scalar(1)));
  writeMask("1700000005.000000.png", cv::Mat(48, 64, CV_16UC1, cv::Scalar(1001)));
  writeMask("1700000006.000000.png", cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, 128)));
  RecordedMasks masks = open();
  for (int i = 1; i <= 6; ++i) {
    const auto result = masks.segment({image_, kFirst_s + i});
    EXPECT_TRUE(result.segmentation.empty()) << i;
    EXPECT_THAT(result.events, UnorderedElementsAre(Pair("segmentation.mask_unreadable", 1U))) << i;
  }
  EXPECT_FALSE(masks.segment({image_, kFirst_s}).segmentation.empty());
}

TEST_F(RecordedMasksTest, SaysThatMasksAreOfAnotherSizeWhenNoneCouldBeUsed) {
  writeMask(kFirst, cv::Mat(24, 32, CV_8UC1, cv::Scalar(1)));
  RecordedMasks masks = open();
  (void)masks.segment({image_, kFirst_s});
  EXPECT_THAT([&] { masks.finish(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr(kFirst), HasSubstr("32x24"), HasSubstr("64x48"))));
}

TEST_F(RecordedMasksTest, LeavesOutAndCountsWhatHasNoName) {
  cv::Mat mask = personAndChair();
  mask(kChair).setTo(200);
  writeMask(kFirst, mask);
  const auto result = open().segment({image_, kFirst_s});
  EXPECT_THAT(result.events, UnorderedElementsAre(Pair("segmentation.class_without_name", 1U)));
  ASSERT_EQ(result.segmentation.instances.size(), 1U);
  EXPECT_EQ(result.segmentation.instances[0].classId, 1);
  EXPECT_EQ(cv::countNonZero(result.segmentation.classIds), kPerson.area());

  folder_.write("classes.txt", "200 drip_bag\n");
  EXPECT_THAT(open().segment({image_, kFirst_s}).events, IsEmpty());
}

TEST_F(RecordedMasksTest, TakesNumbersOfFewBitsAsTheyAreStored) {
  const cv::Mat image = personAndChair() != 0;
  ASSERT_TRUE(cv::imwrite((masks() / kFirst).string(), image, {cv::IMWRITE_PNG_BILEVEL, 1}));
  RecordedMasks masks = open();
  const auto segmentation = masks.segment({image_, kFirst_s}).segmentation;
  EXPECT_EQ(cv::countNonZero(segmentation.classIds == 1), kPerson.area() + kChair.area());
  EXPECT_THAT(masks.notes(), ElementsAre(HasSubstr("have 1 bit a pixel")));
}

TEST_F(RecordedMasksTest, AsksWhatBlackAndWhiteMeans) {
  writeMask(kFirst, cv::Mat(48, 64, CV_8UC1, cv::Scalar(0)));  // nobody in sight yet
  cv::Mat mask = personAndChair();
  mask.setTo(255, mask != 0);
  writeMask(kSecond, mask);
  EXPECT_THAT([&] { (void)open(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr(this->masks().string()), HasSubstr("black and white"),
                                                    HasSubstr("classes: {255: person}"), HasSubstr("--classes"))));
  RecordedMasksOptions options;
  options.folder = masks().string();
  RecordedMasks told(options, folder_.write("labels.yaml", "classes: {255: person}\n"));
  const auto segmentation = told.segment({image_, kSecond_s}).segmentation;
  EXPECT_EQ(cv::countNonZero(segmentation.classIds == 1), kPerson.area() + kChair.area());
  EXPECT_THAT(told.notes(), IsEmpty());
}

TEST_F(RecordedMasksTest, AsksWhatNumbersWithoutNamesMean) {
  cv::Mat mask = personAndChair();
  mask.setTo(150, mask == 1);
  mask.setTo(170, mask == 57);
  writeMask(kFirst, mask);
  EXPECT_THAT([&] { (void)open(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("150, 170"), HasSubstr("--classes"))));
}

TEST_F(RecordedMasksTest, NamesUnknownNumbersOnce) {
  cv::Mat mask = personAndChair();
  mask.setTo(200, mask == 57);
  writeMask(kFirst, mask);
  writeMask(kSecond, mask);
  EXPECT_THAT(open().notes(), ElementsAre(AllOf(HasSubstr("200"), HasSubstr("--classes"))));
}

TEST_F(RecordedMasksTest, TakesSixteenBitsAndThreeEqualChannels) {
  cv::Mat wide;
  personAndChair().convertTo(wide, CV_16U);
  writeMask(kFirst, wide);
  cv::Mat three;
  cv::merge(std::vector<cv::Mat>(3, personAndChair()), three);
  writeMask(kSecond, three);
  RecordedMasks masks = open();
  for (const double stamp_s : {kFirst_s, kSecond_s}) {
    const auto segmentation = masks.segment({image_, stamp_s}).segmentation;
    EXPECT_EQ(cv::norm(segmentation.classIds, personAndChair(), cv::NORM_INF), 0.0) << stamp_s;
  }
  EXPECT_THAT(masks.notes(), ::testing::SizeIs(2));
}

TEST_F(RecordedMasksTest, MayBeNamedInNanosecondsOrByNumber) {
  writeMask("1700000000000000000.png", personAndChair());
  writeMask("1700000000033333000.png", personAndChair());
  EXPECT_FALSE(open().segment({image_, kSecond_s}).segmentation.empty());
  EXPECT_THAT(open().notes(), ElementsAre(HasSubstr("nanoseconds")));
  fs::remove_all(masks());
  fs::create_directories(masks());
  for (const char* name : {"0.png", "1.png", "2.png"}) writeMask(name, personAndChair());
  EXPECT_FALSE(open().segment({image_, 2.0 / 30}).segmentation.empty());
}

TEST_F(RecordedMasksTest, RefusesFoldersThatCannotHoldMasks) {
  EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<core::InputError>(HasSubstr(masks().string())));
  writeMask(kFirst, cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, 128)));
  EXPECT_THAT([&] { (void)open(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr(kFirst), HasSubstr("8-bit single-channel"))));
  fs::remove_all(masks());
  EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<core::InputError>(HasSubstr(masks().string())));
  EXPECT_THAT([] { const RecordedMasks masks(RecordedMasksOptions{}); },
              ThrowsMessage<core::InputError>(HasSubstr("recorded_masks.folder")));
}

TEST_F(RecordedMasksTest, RefusesAClassesFileWithMistakes) {
  writeMask(kFirst, personAndChair());
  folder_.write("classes.txt", "102 trolley\n900 elephant in the room\n");
  EXPECT_THAT([&] { (void)open(); }, ThrowsMessage<core::InputError>(HasSubstr("classes.txt:2")));
}

TEST_F(RecordedMasksTest, GivesGreyValuesOtherMeanings) {
  writeMask(kFirst, personAndChair());
  RecordedMasksOptions options;
  options.folder = masks().string();
  const auto labels = folder_.write("labels.yaml", "names: {100: trolley}\nclasses: {1: trolley}\n");
  RecordedMasks masks(options, labels);
  const auto segmentation = masks.segment({image_, kFirst_s}).segmentation;
  EXPECT_EQ(cv::countNonZero(segmentation.classIds == 100), kPerson.area());
  EXPECT_EQ(cv::countNonZero(segmentation.classIds), kPerson.area());
  ASSERT_EQ(segmentation.instances.size(), 1U);
  EXPECT_EQ(segmentation.instances[0].classId, 100);
  EXPECT_EQ(masks.labelSpace().name(100), "trolley");
}

TEST(RecordedMasksOnARecording, KnowsTheThingsOfTheWard) {
  const fs::path ward = fs::path(WARDSLAM_SHARED_DIR) / "data" / "ward_walking";
  if (!fs::exists(ward)) GTEST_SKIP() << ward << " is absent";
  RecordedMasksOptions options;
  options.folder = (ward / "masks").string();
  RecordedMasks masks(options);
  std::map<std::string, int> seen;
  for (const double stamp_s : {1700000000.0, 1700000003.333333, 1700000006.666667}) {
    const auto result = masks.segment({cv::Mat(480, 640, CV_8UC3), stamp_s});
    EXPECT_THAT(result.events, IsEmpty());
    for (const auto& instance : result.segmentation.instances) {
      ++seen[masks.labelSpace().name(instance.classId)];
      const cv::Mat pixels = result.segmentation.instanceIds == instance.id;
      EXPECT_GT(cv::countNonZero(pixels), 0);
      EXPECT_EQ(cv::countNonZero(pixels(instance.box_px)), cv::countNonZero(pixels));
    }
  }
  for (const char* name : {"person", "bed", "trolley"}) EXPECT_GT(seen[name], 0) << name;
  EXPECT_EQ(seen.count(""), 0U);
}

}  // namespace
}  // namespace wardslam::segmentation
