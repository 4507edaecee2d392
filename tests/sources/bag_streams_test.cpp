#include "bag_streams.h"

#include <gmock/gmock.h>

#include "fake_bag.h"
#include "support/complaint.h"
#include "wardslam/sources/choice_needed.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

BagStreams find(test::FakeBag& bag, const BagTopics& wishes = {}, bool needsInfo = true) {
  return findStreams(bag, wishes, needsInfo, "f.bag", [](const std::string&) {});
}

/// What a RealSense camera publishes.
void addRealSense(test::FakeBag& bag, const std::string& name) {
  bag.addInfo(name + "/color/camera_info", 1);
  bag.addImage(name + "/color/image_raw", "rgb8", 1);
  bag.addCompressed(name + "/color/image_raw/compressed", "rgb8; jpeg compressed bgr8", 1);
  bag.addInfo(name + "/depth/camera_info", 1);
  bag.addImage(name + "/depth/image_rect_raw", "16UC1", 1);
  bag.addImage(name + "/aligned_depth_to_color/image_raw", "16UC1", 1);
  bag.addCompressed(name + "/aligned_depth_to_color/image_raw/compressedDepth", "16UC1; compressedDepth", 1);
  bag.addImage(name + "/infra1/image_rect_raw", "mono8", 1);
}

TEST(BagStreams, TakesColorAndRegisteredDepth) {
  test::FakeBag bag;
  addRealSense(bag, "/camera");
  const BagStreams streams = find(bag);
  EXPECT_EQ(bag.topics()[streams.color].name, "/camera/color/image_raw");
  EXPECT_EQ(bag.topics()[streams.depth].name, "/camera/aligned_depth_to_color/image_raw");
  EXPECT_EQ(bag.topics()[streams.colorInfo.value()].name, "/camera/color/camera_info");
}

TEST(BagStreams, KnowsWhatRealSensesOwnRecorderWrites) {
  test::FakeBag bag;
  bag.addRealSense("/device_0/sensor_0/Depth_0", "mono16", 400, 0.0);
  bag.addRealSense("/device_0/sensor_0/Infrared_1", "8UC1", 400, 0.0);
  bag.addRealSense("/device_0/sensor_1/Color_0", "rgb8", 600, 0.015);
  bag.addNumber("/device_0/sensor_0/option/Depth_Units/value", 0.0001F);
  const BagStreams streams = find(bag);
  const auto nameOf = [&](std::size_t topic) { return bag.topics()[topic].name; };
  EXPECT_EQ(nameOf(streams.color), "/device_0/sensor_1/Color_0/image/data");
  EXPECT_EQ(nameOf(streams.depth), "/device_0/sensor_0/Depth_0/image/data");
  EXPECT_EQ(nameOf(streams.colorInfo.value()), "/device_0/sensor_1/Color_0/info/camera_info");
  EXPECT_EQ(nameOf(streams.depthInfo.value()), "/device_0/sensor_0/Depth_0/info/camera_info");
  EXPECT_EQ(nameOf(streams.colorPlace.value()), "/device_0/sensor_1/Color_0/tf/0");
  EXPECT_EQ(nameOf(streams.depthPlace.value()), "/device_0/sensor_0/Depth_0/tf/0");
  EXPECT_EQ(nameOf(streams.depthUnit.value()), "/device_0/sensor_0/option/Depth_Units/value");
}

TEST(BagStreams, KnowsTheTextsOfRealSensesOwnRecorder) {
  test::FakeBag bag;
  const std::string here = "rotation=1,0,0,0,1,0,0,0,1;translation=0,0,0";
  bag.addRealSenseText("/device_0/sensor_0/Depth_0", "mono16", here);
  bag.addRealSenseText("/device_0/sensor_1/Color_0", "rgb8", here);
  bag.addText("/device_0/sensor_0/option/Depth_Units/value", "0.001000");
  const BagStreams streams = find(bag);
  const auto nameOf = [&](std::size_t topic) { return bag.topics()[topic].name; };
  EXPECT_EQ(nameOf(streams.colorInfo.value()), "/device_0/sensor_1/Color_0/camera_info");
  EXPECT_EQ(nameOf(streams.depthInfo.value()), "/device_0/sensor_0/Depth_0/camera_info");
  EXPECT_EQ(nameOf(streams.colorPlace.value()), "/device_0/sensor_1/Color_0/tf/ref_0");
  EXPECT_EQ(nameOf(streams.depthPlace.value()), "/device_0/sensor_0/Depth_0/tf/ref_0");
  EXPECT_EQ(nameOf(streams.depthUnit.value()), "/device_0/sensor_0/option/Depth_Units/value");
  EXPECT_EQ(realSenseStream("/device_0/sensor_1/Color_0/image/data/compressed"), "/device_0/sensor_1/Color_0");
  EXPECT_EQ(realSenseStream("/camera/image/data"), "");
}

TEST(BagStreams, ListsTwoCamerasAndAsks) {
  test::FakeBag bag;
  addRealSense(bag, "/front");
  addRealSense(bag, "/rear");
  try {
    find(bag);
    FAIL();
  } catch (const ChoiceNeeded& choice) {
    EXPECT_THAT(choice.what(),
                AllOf(HasSubstr("/front/color/image_raw (sensor_msgs/Image, 1)"), HasSubstr("/rear/color/image_raw"),
                      HasSubstr("--color"), Not(HasSubstr("infra"))));
  }
}

TEST(BagStreams, OneThatIsChosenTellsTheOther) {
  test::FakeBag bag;
  addRealSense(bag, "/front");
  addRealSense(bag, "/rear");
  BagTopics wishes;
  wishes.color = "/rear/color/image_raw";
  EXPECT_EQ(bag.topics()[find(bag, wishes).depth].name, "/rear/aligned_depth_to_color/image_raw");
  wishes = {};
  wishes.depth = "front/depth/image_rect_raw";  // the first '/' may be left out
  EXPECT_EQ(bag.topics()[find(bag, wishes).color].name, "/front/color/image_raw");
}

TEST(BagStreams, TakesPackedTopicsWhereThereAreNoOthers) {
  test::FakeBag bag;
  bag.addInfo("/camera/rgb/camera_info", 1);
  bag.addCompressed("/camera/rgb/image_color/compressed", "jpeg", 1);
  bag.addCompressed("/camera/depth/image/compressedDepth", "32FC1; compressedDepth png", 1);
  const BagStreams streams = find(bag);
  EXPECT_EQ(bag.topics()[streams.color].name, "/camera/rgb/image_color/compressed");
  EXPECT_EQ(bag.topics()[streams.depth].name, "/camera/depth/image/compressedDepth");
  EXPECT_EQ(bag.topics()[streams.colorInfo.value()].name, "/camera/rgb/camera_info");
}

TEST(BagStreams, SaysWhatThereIsWhereSomethingIsMissing) {
  test::FakeBag bag;
  bag.addImage("/camera/color/image_raw", "rgb8", 1);
  EXPECT_THAT(
      test::complaintOf([&] { return find(bag); }),
      AllOf(HasSubstr("no topic of depth images"), HasSubstr("/camera/color/image_raw (sensor_msgs/Image, 1)")));
  bag.addImage("/camera/depth/image", "32FC1", 1);
  EXPECT_THAT(test::complaintOf([&] { return find(bag); }), HasSubstr("give --camera"));
  EXPECT_FALSE(find(bag, {}, false).colorInfo);
  BagTopics wishes;
  wishes.color = "/no/such";
  EXPECT_THAT(test::complaintOf([&] { return find(bag, wishes); }), AllOf(HasSubstr("/no/such"), HasSubstr("--color")));
}

}  // namespace
}  // namespace wardslam::sources
