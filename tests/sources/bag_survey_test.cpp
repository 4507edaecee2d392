#include "bag_survey.h"

#include <gmock/gmock.h>

#include "fake_bag.h"
#include "support/complaint.h"

namespace wardslam::sources {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

class BagSurveyTest : public ::testing::Test {
 protected:
  BagSurvey look() {
    BagStreams streams;
    streams.color = 0;
    streams.depth = 1;
    return survey(bag, streams, "f.bag", damage);
  }
  void color(double stamp_s) { bag.addImage("/color", "rgb8", stamp_s); }
  void depth(double stamp_s) { bag.addImage("/depth", "16UC1", stamp_s); }

  test::FakeBag bag;
  std::string warning;
  DamageLog damage{[this](const std::string& sentence) { warning = sentence; }};
};

TEST_F(BagSurveyTest, PairsTheNearestInOrderOfStamps) {
  color(10.0);
  depth(10.015);
  color(10.066);  // later than the one that follows it
  color(10.033);
  depth(10.034);
  depth(10.07);
  const BagSurvey found = look();
  EXPECT_THAT(found.pairs, ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 2)));
  EXPECT_NEAR(found.colors[1].stamp_s, 10.033, 1e-6);
  EXPECT_EQ(found.colors[1].entry, 3U);
}

TEST_F(BagSurveyTest, TakesPlacesAndUnitFromRealSensesOwnRecorder) {
  bag.addRealSense("/device_0/sensor_1/Color_0", "rgb8", 600,
                   -0.25);  // how a point of the device is seen by the stream
  bag.addRealSense("/device_0/sensor_0/Depth_0", "mono16", 400, 0.5);
  bag.addNumber("/device_0/sensor_0/option/Depth Units/value", 0.0001F);
  const BagStreams streams = findStreams(bag, {}, true, "f.bag", [](const std::string&) {});
  const BagSurvey found = survey(bag, streams, "f.bag", damage);
  EXPECT_EQ(found.colorFrame, "/device_0/sensor_1/Color_0");
  EXPECT_EQ(found.depthFrame, "/device_0/sensor_0/Depth_0");
  const auto T_depth_color = found.transforms.T(found.depthFrame, found.colorFrame);
  ASSERT_TRUE(T_depth_color);
  EXPECT_NEAR(T_depth_color->translation().x(), 0.75, 1e-9);
  EXPECT_NEAR(found.depthUnit_m.value(), 0.0001, 1e-9);
}

// The depth camera is turned by a quarter about z against the device, and 1 m along its x; colour sits in the device.
TEST_F(BagSurveyTest, TakesThemFromTextsOfRealSensesOwnRecorder) {
  bag.addRealSenseText("/device_0/sensor_1/Color_0", "rgb8", "rotation=1,0,0,0,1,0,0,0,1;translation=0,0,0");
  bag.addRealSenseText("/device_0/sensor_0/Depth_0", "mono16", "rotation=0,1,0,-1,0,0,0,0,1;translation=1,0,0");
  bag.addText("/device_0/sensor_0/option/Depth_Units/value", "0.000100");
  const BagStreams streams = findStreams(bag, {}, true, "f.bag", [](const std::string&) {});
  const BagSurvey found = survey(bag, streams, "f.bag", damage);
  const auto T_depth_color = found.transforms.T(found.depthFrame, found.colorFrame);
  ASSERT_TRUE(T_depth_color);
  EXPECT_TRUE((*T_depth_color * Eigen::Vector3d(2, 0, 3)).isApprox(Eigen::Vector3d(1, 2, 3), 1e-9));
  EXPECT_EQ(found.depthUnit_m.value(), 0.0001);
  EXPECT_EQ(found.colorInfo.value().k[2], 320.0);
  EXPECT_EQ(found.depthInfo.value().width_px, 640U);
}

TEST_F(BagSurveyTest, DoublesCountOnce) {
  color(10.0);
  color(10.0);
  depth(10.0);
  EXPECT_EQ(look().colors.size(), 1U);
}

TEST_F(BagSurveyTest, ImagesOfTwoClocksAreNoPairs) {
  color(10.0);
  depth(500.0);
  EXPECT_THAT(test::complaintOf([&] { return look(); }), HasSubstr("10.000000 s and 500.000000 s"));
}

TEST_F(BagSurveyTest, AMessageThatCannotBeReadIsLeftOutAndNamed) {
  color(10.0);
  depth(10.0);
  bag.add("/color", "sensor_msgs/Image", 11.0, {1, 2, 3});
  EXPECT_EQ(look().pairs.size(), 1U);
  EXPECT_EQ(damage.counts().at("sources.message_unreadable"), 1U);
  EXPECT_THAT(warning, HasSubstr("f.bag: topic /color, message recorded at 11.000000 s: ends at byte 3"));
}

}  // namespace
}  // namespace wardslam::sources
