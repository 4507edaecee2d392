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
