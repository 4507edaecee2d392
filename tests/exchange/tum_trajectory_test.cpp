#include "wardslam/exchange/tum_trajectory.h"

#include <gmock/gmock.h>

#include <cmath>
#include <optional>

#include "support/full_disk.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::exchange {
namespace {

using core::InputError;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class TumTrajectory : public ::testing::Test {
 protected:
  [[nodiscard]] core::Trajectory read(const std::string& text) {
    return readTumTrajectory(folder.write("trajectory.txt", text),
                             {[this](const std::string& note) { notes.push_back(note); }, {}});
  }

  std::vector<std::string> notes;

  test::TemporaryFolder folder;
};

using ReadTumTrajectory = TumTrajectory;
using ReadTumStamps = TumTrajectory;
using TumTrajectoryWriterTest = TumTrajectory;

TEST_F(ReadTumTrajectory, TakesPositionAndOrientation) {
  // A quarter turn about z, (0, 0, sin 45 deg, cos 45 deg), takes x to y.
  const auto trajectory = read("1305031102.160407 1.5 -2 3e0 0 0 0.7071067811865476 0.7071067811865476\n");
  ASSERT_EQ(trajectory.size(), 1U);
  EXPECT_EQ(trajectory[0].stamp_s, 1305031102.160407);
  EXPECT_TRUE((trajectory[0].T_map_cam * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(1.5, -1, 3), 1e-12));
}

TEST_F(ReadTumTrajectory, SkipsCommentsAndBlankLines) {
  EXPECT_EQ(read("# stamp x y z\n\n  \t\n1 0 0 0 0 0 0 1\n #late comment\n2 0 0 0 0 0 0 1").size(), 2U);
}

TEST_F(ReadTumTrajectory, TakesBlanksTabsCommasAndWindowsLineEnds) {
  const auto trajectory = read("1,2,3,4,0,0,0,1\r\n2\t2\t3\t4\t0\t0\t0\t1\r\n3,  2 3\t4 0 0 0 1  \r\n");
  ASSERT_EQ(trajectory.size(), 3U);
  for (const auto& pose : trajectory) EXPECT_EQ(pose.T_map_cam.translation(), Eigen::Vector3d(2, 3, 4));
}

TEST_F(ReadTumTrajectory, DropsLinesThatHoldNoPose) {
  const auto trajectory = read(
      "1 nan 0 0 0 0 0 1\n"
      "2 0 0 0 -nan 0 0 1\n"
      "3 0 0 0 0 0 0 0\n"
      "4 0 inf 0 0 0 0 1\n"
      "5 0 0 0 0 0 0 1\n");
  ASSERT_EQ(trajectory.size(), 1U);
  EXPECT_EQ(trajectory[0].stamp_s, 5.0);
}

TEST_F(ReadTumTrajectory, NormalisesQuaternions) {
  const auto trajectory = read("1 0 0 0 0 0 3 3\n");
  const Eigen::Matrix3d quarterTurn = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).matrix();
  EXPECT_TRUE(trajectory.at(0).T_map_cam.linear().isApprox(quarterTurn, 1e-12));
}

TEST_F(ReadTumTrajectory, SaysOnceWhereOrientationsAreOdd) {
  static_cast<void>(read("1 0 0 0 0 0 0.70710678 0.7071\n"));
  EXPECT_TRUE(notes.empty());
  static_cast<void>(read("1 0 0 0 0 0 0 1\n2 0 0 0 0.1 0.2 1.5 0\n3 0 0 0 0.1 0.2 1.5 0\n"));
  EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("trajectory.txt:2: "), HasSubstr("angles are not read"))));
  notes.clear();
  static_cast<void>(read("2 0 0 0 0 1 0 0 0 0 1 0\n"));
  EXPECT_THAT(notes, Contains(AllOf(HasSubstr("trajectory.txt:1: "), HasSubstr("no rotation"))));
}

TEST_F(ReadTumTrajectory, SaysWhichOrderIsTakenOfTablesWithoutHeadings) {
  static_cast<void>(read("1,0,0,0,0,0,0,1\n"));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("order x y z w")));
  notes.clear();
  static_cast<void>(read("timestamp,tx,ty,tz,qx,qy,qz,qw\n1,0,0,0,0,0,0,1\n"));
  static_cast<void>(read("1,0 0,5 0,5 0,5 0,0 0,0 0,0 1,0\n"));
  EXPECT_TRUE(notes.empty());
}

TEST_F(ReadTumTrajectory, SortsByTimeAndTheLaterOfTwoLinesCounts) {
  const auto trajectory = read("3 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 7 0 0 0 0 0 1\n2 8 0 0 0 0 0 1\n");
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_EQ(trajectory[0].stamp_s, 1.0);
  EXPECT_EQ(trajectory[1].T_map_cam.translation().x(), 8.0);
  EXPECT_EQ(trajectory[2].stamp_s, 3.0);
}

TEST_F(ReadTumTrajectory, RefusesMalformedLinesNamingFileAndLine) {
  const std::string good = "# comment\n1 0 0 0 0 0 0 1\n";
  for (const char* bad : {"2 0 0 0 0 0 1", "2 0 0 0 0 0 0 1 9", "2 0 0 zero 0 0 0 1", "2 0 0 0 0 0 0 1.0x", "PK",
                          "2 1e308 0 0 0 0 0 1"}) {
    EXPECT_THAT([&] { (void)read(good + bad + "\n"); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("trajectory.txt:3: "), HasSubstr(bad))))
        << bad;
  }
}

/// The pose that the files below describe: a quarter turn about z at (1, 2, 3).
void expectThePose(const core::Trajectory& trajectory, double stamp_s) {
  ASSERT_EQ(trajectory.size(), 1U);
  EXPECT_NEAR(trajectory[0].stamp_s, stamp_s, 1e-6);
  const Eigen::Isometry3d expected =
      Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(trajectory[0].T_map_cam.isApprox(expected, 1e-6));
}

TEST_F(ReadTumTrajectory, TakesTheOrderFromTheHeadings) {
  const std::string wxyz = "1,2,3,0.70710678,0,0,0.70710678";
  expectThePose(read("#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
                     "q_RS_z []\n1700000003333333333," +
                     wxyz + "\n"),
                1700000003.333333);
  expectThePose(read("timestamp,tx,ty,tz,qw,qx,qy,qz\n5.5," + wxyz + "\n"), 5.5);
  expectThePose(read("num,t,x,y,z,qx,qy,qz,qw\n7,5.5,1,2,3,0,0,0.70710678,0.70710678\n"), 5.5);
  expectThePose(read("# qx qy qz qw x y z timestamp\n0 0 0.70710678 0.70710678 1 2 3 5.5\n"), 5.5);
  expectThePose(read("#timestamp, p_x, p_y, p_z, q_w, q_x, q_y, q_z, v_x, v_y, v_z\n5.5," + wxyz + ",9,9,9\n"), 5.5);
  EXPECT_THAT(notes.back(), HasSubstr("headings"));
}

TEST_F(ReadTumTrajectory, KnowsWhatHasNoHeadingsByItsNumbers) {
  const std::string pose = "5.5 1 2 3 0 0 0.70710678 0.70710678";
  expectThePose(read(pose + " 12\n"), 5.5);
  expectThePose(read("12 " + pose + "\n"), 5.5);
  EXPECT_THAT(notes.back(), HasSubstr("9 columns"));
  EXPECT_THAT([&] { (void)read("5.5 1 2 3 0 0 9 9 12\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("trajectory.txt:1")));
}

TEST_F(ReadTumTrajectory, TakesTheMatricesOfKittiForOneAnImage) {
  const auto trajectory = read("1 0 0 0 0 1 0 0 0 0 1 0\n0 -1 0 1 1 0 0 2 0 0 1 3\n");
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory[1].stamp_s, 1.0);
  expectThePose({trajectory[1]}, 1.0);
  EXPECT_THAT(notes.back(), HasSubstr("KITTI"));
}

TEST_F(ReadTumTrajectory, TakesOtherClocksMarksAndDecimalCommas) {
  expectThePose(read("1700000003333 1 2 3 0 0 0.70710678 0.70710678\n"), 1700000003.333);
  EXPECT_THAT(notes.back(), HasSubstr("milliseconds"));
  expectThePose(read("1700000003333333333.000000 1 2 3 0 0 0.70710678 0.70710678\n"), 1700000003.333333);
  expectThePose(read("\xEF\xBB\xBF"
                     "5.5 1 2 3 0 0 0.70710678 0.70710678 \r\n"),
                5.5);
  expectThePose(read("5.5;1;2;3;0;0;0.70710678;0.70710678\n"), 5.5);
  expectThePose(read("5,5 1,0 2,0 3,0 0,0 0,0 0,70710678 0,70710678\n"), 5.5);
  EXPECT_THAT(
      [&] {
        (void)read(
            std::string("\xFF\xFE"
                        "1\0",
                        4));
      },
      ThrowsMessage<core::InputError>(HasSubstr("UTF-16")));
}

TEST_F(ReadTumTrajectory, CountsImagesWhereItIsToldTheirRate) {
  const std::string numbered = "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n";
  EXPECT_EQ(read(numbered).back().stamp_s, 2.0);
  const auto file = folder.write("numbered.txt", numbered);
  EXPECT_TRUE(numbersImages(file));
  TrajectoryReading reading;
  reading.rate_hz = 20.0;
  EXPECT_EQ(readTumTrajectory(file, reading).back().stamp_s, 0.1);
}

TEST_F(ReadTumTrajectory, RefusesAFileWithoutPoses) {
  for (const char* text : {"", "# only a comment\n", "1 nan nan nan nan nan nan nan\n"}) {
    EXPECT_THAT([&] { (void)read(text); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("trajectory.txt"), HasSubstr("holds no pose"))));
  }
}

TEST_F(ReadTumTrajectory, RefusesWhatCannotBeOpened) {
  for (const auto& path : {folder.path() / "missing.txt", folder.path()}) {
    EXPECT_THAT([&] { (void)readTumTrajectory(path); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr(path.string()), HasSubstr("cannot be opened"))));
  }
}

TEST_F(ReadTumStamps, TakesTheFirstColumnInOrder) {
  const auto file = folder.write("rgb.txt", "# color images\n2.5 rgb/2.5.png\n1.25 rgb/1.25.png\n");
  EXPECT_THAT(readTumStamps(file), ElementsAre(1.25, 2.5));
}

TEST_F(ReadTumStamps, RefusesOtherFiles) {
  EXPECT_THAT([&] { (void)readTumStamps(folder.write("a.txt", "1 a.png\nrgb/a.png 2\n")); },
              ThrowsMessage<core::InputError>(HasSubstr("a.txt:2: expected a timestamp")));
  EXPECT_THAT([&] { (void)readTumStamps(folder.write("b.txt", "# nothing\n")); },
              ThrowsMessage<core::InputError>(HasSubstr("b.txt: holds no timestamp")));
}

core::StampedPose halfTurnAboutX() {
  // (sin 90 deg, 0, 0, cos 90 deg)
  return {1305031102.1604071, Eigen::Translation3d(1.5, -2, 1.0 / 3) * Eigen::Quaterniond(0, 1, 0, 0)};
}

TEST_F(TumTrajectoryWriterTest, WritesMicrosecondsAndNanometres) {
  const auto file = folder.path() / "out.txt";
  TumTrajectoryWriter writer(file);
  writer.write(halfTurnAboutX());
  writer.finish();
  EXPECT_EQ(test::readText(file),
            "# timestamp tx ty tz qx qy qz qw\n"
            "1305031102.160407 1.500000000 -2.000000000 0.333333333 1.000000000 0.000000000 0.000000000 0.000000000\n");
}

TEST_F(TumTrajectoryWriterTest, WhatItWritesReadsBack) {
  const auto file = folder.path() / "out.txt";
  const Eigen::Isometry3d T =
      Eigen::Translation3d(0.1, 20.25, -3) * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 3).normalized());
  {
    TumTrajectoryWriter writer(file);
    writer.write({10.5, T});
    writer.write({11.5, T.inverse()});
  }
  const auto trajectory = readTumTrajectory(file);
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory[1].stamp_s, 11.5);
  EXPECT_TRUE(trajectory[0].T_map_cam.isApprox(T, 1e-8));
  EXPECT_TRUE(trajectory[1].T_map_cam.isApprox(T.inverse(), 1e-8));
}

TEST_F(TumTrajectoryWriterTest, EveryLineIsOnDiskAtOnceButUnderThePartialName) {
  const auto file = folder.path() / "out.txt";
  const auto partial = folder.path() / "out.txt.partial";
  TumTrajectoryWriter writer(file);
  writer.write(halfTurnAboutX());
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(readTumTrajectory(partial).size(), 1U);

  writer.finish();
  EXPECT_FALSE(std::filesystem::exists(partial));
  EXPECT_EQ(readTumTrajectory(file).size(), 1U);
}

TEST_F(TumTrajectoryWriterTest, PosesOutlastAFullDisk) {
  const auto file = folder.path() / "out.txt";
  TumTrajectoryWriter writer(file);
  const auto write = [&](int from, int to) {
    for (int i = from; i < to; ++i) writer.write({static_cast<double>(i), Eigen::Isometry3d::Identity()});
  };
  write(0, 5);
  {
    const test::FullDisk full;
    write(5, 100);
    EXPECT_TRUE(writer.isBehind());
  }
  write(100, 101);
  EXPECT_FALSE(writer.isBehind());
  writer.finish();
  EXPECT_EQ(readTumTrajectory(file).size(), 101U);
}

TEST_F(TumTrajectoryWriterTest, FinishesWhenItGoesAway) {
  const auto file = folder.path() / "out.txt";
  TumTrajectoryWriter(file).write(halfTurnAboutX());
  EXPECT_EQ(readTumTrajectory(file).size(), 1U);
}

TEST_F(TumTrajectoryWriterTest, ReportsWhatCannotBeWritten) {
  EXPECT_THAT([&] { TumTrajectoryWriter(folder.path() / "missing" / "out.txt"); },
              ThrowsMessage<core::InputError>(HasSubstr("cannot be created")));

  // A folder of that name that is not empty cannot be replaced by the finished file.
  folder.write("out.txt/occupied", "");
  std::optional<TumTrajectoryWriter> writer(std::in_place, folder.path() / "out.txt");
  writer->write(halfTurnAboutX());
  EXPECT_THAT([&] { writer->finish(); }, ThrowsMessage<core::InputError>(HasSubstr("cannot be replaced")));
  writer.reset();
  EXPECT_EQ(readTumTrajectory(folder.path() / "out.txt.partial").size(), 1U) << "what was written must stay";
}

}  // namespace
}  // namespace wardslam::exchange
