#include "wardslam/pipeline/frame_table.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* kHeadings =
    "timestamp,state,key_points,dynamic_key_points,inliers,held_by_depth,keyframe,piece\n";

core::Frame frameAt(double stamp_s, std::size_t keypoints, std::size_t dynamic) {
  core::Frame frame;
  frame.stamp_s = stamp_s;
  frame.features.keypoints.resize(keypoints);
  for (std::size_t i = 0; i < dynamic; ++i) frame.features.keypoints[i].motion = core::Motion::Dynamic;
  return frame;
}

odometry::OdometryResult lostInPieceThree() {
  odometry::OdometryResult result;
  result.state = odometry::State::Lost;
  result.inliers = 4;
  result.piece = 3;
  return result;
}

TEST(FrameTable, HasALineForEveryFrameAsItComes) {
  const test::TemporaryFolder folder;
  FrameTable table(folder.path() / "frames.csv");
  table.setStampOrigin(1000.0);
  odometry::OdometryResult tracked;
  tracked.state = odometry::State::Ok;
  tracked.inliers = 120;
  tracked.isHeldByDepth = true;
  tracked.keyframe = std::make_shared<odometry::Keyframe>();
  table.onFrame(frameAt(1000.5, 200, 50), tracked);
  const std::string first = std::string(kHeadings) + "0.500000,ok,200,50,120,1,1,0\n";
  EXPECT_EQ(test::readText(folder.path() / "frames.csv.partial"), first);
  table.onFrame(frameAt(1000.75, 3, 0), lostInPieceThree());
  table.finish();
  EXPECT_EQ(test::readText(folder.path() / "frames.csv"), first + "0.750000,lost,3,0,4,0,0,3\n");
}

TEST(FrameTable, IsReadAsItWasWritten) {
  const test::TemporaryFolder folder;
  const auto rows = readFrameTable(
      folder.write("frames.csv", std::string(kHeadings) + "0.5,ok,200,50,120,1,1,0\n0.75,lost,3,0,4,0,0,3\n"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].stamp_s, 0.5);
  EXPECT_EQ(rows[0].state, odometry::State::Ok);
  EXPECT_EQ(rows[0].keypoints, 200U);
  EXPECT_EQ(rows[0].dynamicKeypoints, 50U);
  EXPECT_EQ(rows[0].inliers, 120);
  EXPECT_TRUE(rows[0].isHeldByDepth);
  EXPECT_TRUE(rows[0].isKeyframe);
  EXPECT_EQ(rows[1].state, odometry::State::Lost);
  EXPECT_FALSE(rows[1].isKeyframe);
  EXPECT_EQ(rows[1].piece, 3U);
}

TEST(FrameTable, LeavesOutALastLineThatIsCutOff) {
  const test::TemporaryFolder folder;
  const auto rows =
      readFrameTable(folder.write("frames.csv", std::string(kHeadings) + "0.5,ok,200,50,120,1,1,0\n0.75,lo"));
  EXPECT_EQ(rows.size(), 1U);
  EXPECT_TRUE(readFrameTable(folder.write("empty.csv", kHeadings)).empty());
}

TEST(FrameTable, SaysWhichLineIsNone) {
  const test::TemporaryFolder folder;
  const std::string good = "0.75,lost,3,0,4,0,0,3\n";
  for (const std::string bad : {"nan,ok,200,50,120,1,1,0\n", "0.5,asleep,200,50,120,1,1,0\n", "0.5,ok,200,50,120,1,1\n",
                                "0.5,ok,10,50,120,1,1,0\n", "0.5,ok,-1,0,120,1,1,0\n", "0.5,ok,200,50,120,2,1,0\n"}) {
    const auto file = folder.write("frames.csv", kHeadings + bad + good);
    EXPECT_THAT([&] { (void)readFrameTable(file); }, ThrowsMessage<core::InputError>(HasSubstr("frames.csv:2: ")))
        << bad;
  }
  EXPECT_THROW((void)readFrameTable(folder.path() / "absent.csv"), core::InputError);
}

}  // namespace
}  // namespace wardslam::pipeline
