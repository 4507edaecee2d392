#include "wardslam/pipeline/zone_watch.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace wardslam::pipeline {
namespace {

using ::testing::ElementsAre;

/// Zone "a" from x = 0 to 2 m, zone "b" from 2 to 4 m.
mapping::Zones twoZones() {
  return mapping::Zones({{"a", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {"b", {{2.001, 0}, {4, 0}, {4, 2}, {2.001, 2}}}});
}

class ZoneWatchTest : public ::testing::Test {
 protected:
  void goTo(double x_m, double height_m = 1.0) {
    core::Frame frame;
    frame.stamp_s = stamp_s_ += 0.5;
    odometry::OdometryResult odometry;
    odometry.state = odometry::State::Ok;
    odometry.T_map_cam.translation() = Eigen::Vector3d(x_m, 1.0, height_m);
    watch_.onFrame(frame, odometry);
  }
  void getLost() {
    core::Frame frame;
    frame.stamp_s = stamp_s_ += 0.5;
    odometry::OdometryResult odometry;
    odometry.state = odometry::State::Lost;
    watch_.onFrame(frame, odometry);
  }

  double stamp_s_ = 100.0;
  std::vector<std::string> heard_;
  ZoneWatch watch_{twoZones(), [this](const std::string& left, const std::string& entered, double) {
                     heard_.push_back(left + ">" + entered);
                   }};
};

TEST_F(ZoneWatchTest, AddsTimeAndWayUp) {
  for (const double x_m : {0.5, 1.0, 1.5, 2.5, 3.5}) goTo(x_m);
  EXPECT_DOUBLE_EQ(watch_.stays().at("a").time_s, 1.0);
  EXPECT_DOUBLE_EQ(watch_.stays().at("a").distance_m, 1.0);
  EXPECT_DOUBLE_EQ(watch_.stays().at("b").time_s, 1.0);
  EXPECT_DOUBLE_EQ(watch_.stays().at("b").distance_m, 2.0);
  EXPECT_EQ(watch_.stays().count(""), 0U);
}

TEST_F(ZoneWatchTest, TellsEveryEntry) {
  for (const double x_m : {0.5, 1.0, 2.5, 1.0, 5.0, 5.5}) goTo(x_m);
  EXPECT_THAT(heard_, ElementsAre(">a", "a>b", "b>a", "a>"));
  EXPECT_EQ(watch_.stays().at("a").entries, 2);
  EXPECT_EQ(watch_.stays().at("").entries, 1);
}

TEST_F(ZoneWatchTest, ALiftIsNoWayOverTheFloor) {
  goTo(0.5, 1.0);
  goTo(0.5, 2.0);
  EXPECT_DOUBLE_EQ(watch_.stays().at("a").distance_m, 0.0);
}

TEST_F(ZoneWatchTest, DoesNotCountWhileLost) {
  goTo(0.5);
  getLost();
  goTo(3.0);
  EXPECT_DOUBLE_EQ(watch_.stays().at("a").time_s, 0.0);
  EXPECT_DOUBLE_EQ(watch_.stays().at("b").distance_m, 0.0) << "the way is not known";
  EXPECT_THAT(heard_, ElementsAre(">a", "a>b"));
}

}  // namespace
}  // namespace wardslam::pipeline
