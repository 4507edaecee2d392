#include "plots.h"

#include <gmock/gmock.h>

namespace wardslam::report {
namespace {

using Json = nlohmann::ordered_json;

pipeline::FrameRow frameAt(double stamp_s, std::size_t keypoints, std::size_t dynamic, int inliers) {
  pipeline::FrameRow frame;
  frame.stamp_s = stamp_s;
  frame.state = odometry::State::Ok;
  frame.keypoints = keypoints;
  frame.dynamicKeypoints = dynamic;
  frame.inliers = inliers;
  return frame;
}

Json plotNamed(const Json& data, const std::string& id) {
  for (const auto& plot : data.at("plots")) {
    if (plot.at("id") == id) return plot;
  }
  return nullptr;
}

TEST(Plots, HaveARowForEveryFrame) {
  RunRecord run;
  run.frames = {frameAt(1000.0, 800, 200, 300), frameAt(1000.5, 0, 0, 0), frameAt(1001.0, 3, 1, 2)};
  run.frames[1].state = odometry::State::Lost;
  const auto data = plotData(run, {{1000.25, 0.123456789}}, PlanView(run, {}));
  EXPECT_EQ(plotNamed(data, "error").at("rows"), Json::parse("[[0.25, 0.12346]]"));
  EXPECT_EQ(plotNamed(data, "dynamic").at("rows"), Json::parse("[[0.0, 25.0], [0.5, 0.0], [1.0, 33.3]]"));
  EXPECT_EQ(plotNamed(data, "keypoints").at("rows"),
            Json::parse("[[0.0, 800, 600, 300], [0.5, 0, 0, 0], [1.0, 3, 2, 2]]"));
  EXPECT_EQ(data.at("lost"), Json::parse("[[0.5, 1.0]]"));
  EXPECT_EQ(data.at("stride"), 1);
}

TEST(Plots, ShowWhatTheRunTookOfTheComputer) {
  RunRecord run;
  run.frames = {frameAt(1000.0, 800, 200, 300)};
  run.load = {{1001.0, 30, 25.125, 2, 60.0, 20.5, 10.0, 0.5, 3, 100.06, 12},
              {1002.0, 30, 26.0, 0, 10.0, 0, 0, 0, 0, 101.0, 12}};
  const auto data = plotData(run, {}, PlanView(run, {}));
  EXPECT_EQ(plotNamed(data, "load").at("rows"), Json::parse("[[1.0, 25.13, 45.25], [2.0, 26.0, null]]"));
  EXPECT_EQ(plotNamed(data, "memory").at("rows"), Json::parse("[[1.0, 100.1], [2.0, 101.0]]"));
  EXPECT_EQ(plotNamed(data, "waiting").at("rows"), Json::parse("[[1.0, 3, 12], [2.0, 0, 12]]"));
}

TEST(Plots, OfLongRunsLeaveRowsOut) {
  RunRecord run;
  for (int i = 0; i < 20001; ++i) run.frames.push_back(frameAt(i, 10, 0, 5));
  const auto data = plotData(run, {}, PlanView(run, {}));
  EXPECT_EQ(data.at("stride"), 2);
  const Json rows = plotNamed(data, "dynamic").at("rows");
  ASSERT_EQ(rows.size(), 10001U);
  EXPECT_EQ(rows[1][0], 2.0);
  EXPECT_TRUE(plotNamed(data, "error").is_null());
}

TEST(Plots, TellWhereTheCameraWasInTheDrawing) {
  RunRecord run;
  for (const double x_m : {0.0, 2.0}) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().x() = x_m;
    run.trajectory.push_back({50.0 + x_m, pose});
  }
  const core::Trajectory noTruth;
  const PlanView plan(run, noTruth);
  const Json way = plotData(run, {}, plan).at("way");
  ASSERT_EQ(way.size(), 2U);
  EXPECT_EQ(way[1][0], 2.0);
  EXPECT_EQ(way[1][1].get<int>() - way[0][1].get<int>(), 320);  // 160 px a metre at most
  EXPECT_EQ(way[1][2], way[0][2]);
}

}  // namespace
}  // namespace wardslam::report
