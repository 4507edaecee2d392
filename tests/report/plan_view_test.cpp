#include "plan_view.h"

#include <gmock/gmock.h>

#include <regex>

#include "support/hand_made_map.h"
#include "wardslam/building/rooms_of_map.h"

namespace wardslam::report {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

RunRecord runWith(mapping::SemanticMap map) {
  RunRecord run;
  run.rooms = building::roomsOf(map);
  run.map = std::move(map);
  return run;
}

core::Trajectory straightWay(double start_s) {
  core::Trajectory way;
  for (int i = 0; i < 3; ++i) {
    way.push_back({start_s + i, Eigen::Isometry3d(Eigen::Translation3d(0.5 * i, 1.0, 1.2))});
  }
  return way;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(PlanView, NamesWhatIsPointedAt) {
  RunRecord run = runWith(test::makeWard());
  run.trajectory = straightWay(test::kWardEnd_s - 100.0);
  const core::Trajectory noTruth;
  const std::string svg = PlanView(run, noTruth).svg();
  EXPECT_EQ(count(svg, "<polygon class=\"thing"), 7U);
  EXPECT_EQ(count(svg, "<polygon class=\"thing gone\""), 1U);
  EXPECT_EQ(count(svg, "<polygon class=\"zone\""), 2U);
  EXPECT_THAT(svg, HasSubstr("<title>zone clean zone\n24.0 m²</title>"));
  EXPECT_THAT(svg,
              HasSubstr("<title>bed #5\nclass 60 bed, 75 % sure\nseen in 5 images, from 0.0 s to 99.0 s\nin ward"));
  EXPECT_THAT(svg, AllOf(HasSubstr("<path class=\"way\""), Not(HasSubstr("class=\"truth\""))));
  EXPECT_THAT(svg, HasSubstr("href=\"data:image/png;base64,"));
}

/// A room of 4 m by 5.9 m, and one that is 3.8 m wide; between them a gap of 0.9 m.
TEST(PlanView, ShowsRoomsAndDoors) {
  const RunRecord run = runWith(test::makeWard());
  const core::Trajectory noTruth;
  const std::string svg = PlanView(run, noTruth).svg();
  EXPECT_EQ(count(svg, "<path class=\"room\""), 2U);
  EXPECT_EQ(count(svg, "<path class=\"door\""), 1U);
  EXPECT_TRUE(std::regex_search(svg, std::regex("<title>door between [^\n]*clean zone[^\n]*\n[01]\\.[0-9] m wide")));
}

TEST(PlanView, CutsWhatIsNotOfTheRoomOutOfIt) {
  RunRecord run;
  run.map.emplace();
  run.map->keyframes[1] = {};
  run.rooms.all.push_back({1, "room 1", 96.0, {1.0, 1.0}, {}});
  run.rooms.ids = cv::Mat(200, 200, CV_32SC1, cv::Scalar(1));
  run.rooms.ids(cv::Rect(80, 80, 40, 40)).setTo(0);  // 2 m by 2 m
  run.rooms.ids(cv::Rect(10, 10, 10, 10)).setTo(0);  // 0.5 m by 0.5 m
  const core::Trajectory noTruth;
  const std::string svg = PlanView(run, noTruth).svg();
  const auto begin = svg.find("<path class=\"room\"");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(count(svg.substr(begin, svg.find('>', begin) - begin), "Z"), 2U);
}

TEST(PlanView, EscapesNames) {
  auto map = test::makeWard();
  map.zones[0].name = "<script>alert(1)</script>";
  map.objects[1].zone = "a\"b";
  const RunRecord run = runWith(map);
  const core::Trajectory noTruth;
  const std::string svg = PlanView(run, noTruth).svg();
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, AllOf(HasSubstr("zone &lt;script&gt;"), HasSubstr("in a&quot;b")));
}

TEST(PlanView, NamesNothingThatLiesOutside) {
  auto map = test::makeWard();
  map.zones.push_back({"far away", {{90, 90}, {91, 90}, {91, 91}}});
  const RunRecord run = runWith(map);
  const core::Trajectory noTruth;
  EXPECT_THAT(PlanView(run, noTruth).svg(), Not(HasSubstr(">far away</text>")));
}

TEST(PlanView, WithoutAMapShowsTheWays) {
  RunRecord run;
  const core::Trajectory truth = straightWay(50.0);
  EXPECT_THAT(PlanView(run, {}).svg(), IsEmpty());
  run.trajectory = straightWay(50.0);
  const std::string svg = PlanView(run, truth).svg();
  EXPECT_THAT(svg, AllOf(HasSubstr("<path class=\"way\""), HasSubstr("<path class=\"truth\"")));
  EXPECT_THAT(svg, Not(HasSubstr("<image")));
}

TEST(PlanView, DrawsNoLineWhereTheCameraWasLost) {
  RunRecord run;
  for (int i = 0; i < 10; ++i) {
    const double late_s = i < 5 ? 0.0 : 0.6;  // 0.7 s for the sixth pose, seven times the usual step
    run.trajectory.push_back({0.1 * i + late_s, Eigen::Isometry3d(Eigen::Translation3d(0.1 * i, 0.0, 0.0))});
  }
  const core::Trajectory noTruth;
  const std::string svg = PlanView(run, noTruth).svg();
  const auto begin = svg.find("<path class=\"way\"");
  ASSERT_NE(begin, std::string::npos);
  const std::string way = svg.substr(begin, svg.find("/>", begin) - begin);
  EXPECT_EQ(count(way, "M"), 2U);
  EXPECT_EQ(count(way, "L"), 8U);
}

}  // namespace
}  // namespace wardslam::report
