#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli_test_support.h"
#include "support/temporary_folder.h"

namespace wardslam {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class EvalCommand : public ::testing::Test {
 protected:
  [[nodiscard]] static test::CommandResult eval(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "eval");
    return test::runProgram("wardslam", arguments);
  }

  /// Exit code, nothing on standard output and one sentence on standard error.
  static void expectError(const test::CommandResult& result, int exitCode, const std::string& part) {
    EXPECT_EQ(result.exitCode, exitCode);
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, AllOf(StartsWith("wardslam: "), HasSubstr(part), EndsWith("\n")));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  }

  std::string write(const std::string& name, const std::string& text) const {
    return folder.write(name, text).string();
  }

  test::TemporaryFolder folder;

  // A cross, two of whose arms the estimate stretches by 0.1 m and two by 0.3 m: the best alignment is none, the
  // errors are 0.1, 0.1, 0.3 and 0.3 m.
  const std::string groundTruth = write("groundtruth.txt",
                                        "0.0  1  0 0 0 0 0 1\n"
                                        "0.1 -1  0 0 0 0 0 1\n"
                                        "0.2  0  1 0 0 0 0 1\n"
                                        "0.3  0 -1 0 0 0 0 1\n");
  const std::string trajectory = write("trajectory.txt",
                                       "0.0  1.1  0   0 0 0 0 1\n"
                                       "0.1 -1.1  0   0 0 0 0 1\n"
                                       "0.2  0    1.3 0 0 0 0 1\n"
                                       "0.3  0   -1.3 0 0 0 0 1\n");
};

TEST_F(EvalCommand, SaysWhereOneOfBothSeemsToBeInMillimetres) {
  const auto millimetres = write("millimetres.txt",
                                 "0.0 1100 0 0 0 0 0 1\n0.1 -1100 0 0 0 0 0 1\n0.2 0 1300 0 0 0 0 1\n"
                                 "0.3 0 -1300 0 0 0 0 1\n");
  for (const auto& arguments : {std::vector{groundTruth, millimetres}, std::vector{millimetres, groundTruth}}) {
    const auto result = eval(arguments);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr(millimetres + ": is about 1000 times as large as " + groundTruth));
  }
  EXPECT_THAT(eval({groundTruth, trajectory}).err, IsEmpty());
}

TEST_F(EvalCommand, TakesNumbersOfImagesForTimeWhereOneFileHasThem) {
  const auto numbered =
      write("numbered.txt", "0  1  0 0 0 0 0 1\n1 -1  0 0 0 0 0 1\n2  0  1 0 0 0 0 1\n3  0 -1 0 0 0 0 1\n");
  const auto at = [&](const std::string& b, const std::string& c, const std::string& d) {
    return write("timed.txt", "0.0 1.1 0 0 0 0 0 1\n" + b + " -1.1 0 0 0 0 0 1\n" + c + " 0 1.3 0 0 0 0 1\n" + d +
                                  " 0 -1.3 0 0 0 0 1\n");
  };
  const auto usual = eval({numbered, at("0.033333", "0.066667", "0.1"), "--json"});
  EXPECT_EQ(usual.exitCode, 0) << usual.err;
  EXPECT_THAT(usual.err, AllOf(HasSubstr("numbered.txt"), HasSubstr("30 a second")));
  EXPECT_EQ(nlohmann::json::parse(usual.out).at("ate").at("pairs"), 4);
  expectError(eval({numbered, at("0.2", "0.4", "0.6")}), 1, "--rate");
  const auto told = eval({numbered, at("0.2", "0.4", "0.6"), "--rate", "5", "--json"});
  EXPECT_EQ(nlohmann::json::parse(told.out).at("ate").at("pairs"), 4);
  const auto seconds = eval({numbered, at("1.0", "2.0", "3.0"), "--json"});
  EXPECT_THAT(seconds.err, IsEmpty());
  EXPECT_EQ(nlohmann::json::parse(seconds.out).at("ate").at("pairs"), 4);
}

/// By the time of day no rate leads to it.
TEST_F(EvalCommand, TakesTheTimesOfNumbersFromWhereThereAreAsMany) {
  const auto ofDay = write("day/truth.txt",
                           "1305031102.0 1 0 0 0 0 0 1\n1305031102.1 -1 0 0 0 0 0 1\n1305031102.2 0 1 0 0 0 0 1\n"
                           "1305031102.3 0 -1 0 0 0 0 1\n1305031102.4 0 0 0 0 0 0 1\n");
  const auto kitti = [&](const std::string& name, const std::vector<std::string>& positions) {
    std::string text;
    for (const std::string& x : positions) text += "1 0 0 " + x + " 0 1 0 0 0 0 1 0\n";
    return write(name, text);
  };
  const auto five = eval({ofDay, kitti("five.txt", {"1.1", "-1.1", "0", "0", "0"}), "--json"});
  EXPECT_EQ(five.exitCode, 0) << five.err;
  EXPECT_THAT(five.err, AllOf(HasSubstr("five.txt: numbers the images"), HasSubstr("truth.txt lists")));
  EXPECT_EQ(nlohmann::json::parse(five.out).at("ate").at("pairs"), 5);

  const auto two = kitti("two.txt", {"0.5", "0.25"});
  const auto none = eval({ofDay, two});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_THAT(none.err, HasSubstr("two.txt: counts by one, but neither"));
  write("day/rgb.txt", "1305031102.1 a.png\n1305031102.3 b.png\n");
  const auto images = eval({ofDay, two, "--json"});
  EXPECT_EQ(images.exitCode, 0) << images.err;
  EXPECT_THAT(images.err, HasSubstr("rgb.txt lists"));
  EXPECT_EQ(nlohmann::json::parse(images.out).at("ate").at("pairs"), 2);
  const auto fromOne = write("one.txt", "1 0.5 0 0 0 0 0 1\n2 0.25 0 0 0 0 0 1\n");
  EXPECT_EQ(eval({ofDay, fromOne}).exitCode, 0);
}

TEST_F(EvalCommand, TakesTheOrderOfTheHeadings) {
  const auto euroc = write("euroc.csv",
                           "#timestamp [ns], p_x [m], p_y [m], p_z [m], q_w [], q_x [], q_y [], q_z []\n"
                           "0,1.1,0,0,1,0,0,0\n100000000,-1.1,0,0,1,0,0,0\n200000000,0,1.3,0,1,0,0,0\n"
                           "300000000,0,-1.3,0,1,0,0,0\n");
  const auto result = eval({groundTruth, euroc, "--json"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("headings"), HasSubstr("nanoseconds")));
  EXPECT_EQ(nlohmann::json::parse(result.out).at("ate").at("pairs"), 4);
}

TEST_F(EvalCommand, PrintsATable) {
  const auto result = eval({groundTruth, trajectory});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_EQ(result.out,
            "                      rmse        mean      median         std         min         max   pairs\n"
            "ATE [m]           0.223607    0.200000    0.200000    0.100000    0.100000    0.300000       4\n"
            "RPE [m/s]                -           -           -           -           -           -       0\n"
            "RPE [deg/s]              -           -           -           -           -           -       0\n"
            "coverage          1.000000\n");
}

TEST_F(EvalCommand, PrintsJson) {
  const auto result = eval({groundTruth, trajectory, "--json"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_NEAR(json.at("ate").at("mean").get<double>(), 0.2, 1e-12);
  EXPECT_EQ(json.at("ate").at("pairs"), 4);
  EXPECT_NEAR(json.at("ate_sim3").at("scale").get<double>(), 2.4 / 2.9, 1e-6) << "arms of 1.1 and 1.3 where 1 is true";
  EXPECT_NEAR(json.at("ate_sim3").at("max").get<double>(), 1.0 - 1.1 * 2.4 / 2.9, 1e-6);
  EXPECT_NEAR(json.at("coverage").get<double>(), 1.0, 1e-12);
  EXPECT_EQ(json.at("rpe").at("pairs"), 0);
  EXPECT_TRUE(json.at("rpe").at("rotation_deg_per_s").at("rmse").is_null()) << "too short for a figure per second";
}

TEST_F(EvalCommand, GivesDriftPerSecond) {
  std::string still;
  std::string sliding;
  for (int i = 0; i <= 40; ++i) {
    const double stamp_s = i / 8.0;
    still += std::to_string(stamp_s) + " 0 0 0 0 0 0 1\n";
    sliding += std::to_string(stamp_s) + " " + std::to_string(0.5 * stamp_s) + " 0 0 0 0 0 1\n";
  }
  const auto result = eval({"--json", write("still.txt", still), write("sliding.txt", sliding)});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const auto rpe = nlohmann::json::parse(result.out).at("rpe");
  // A second is 8 of 41 poses: 32 have a partner before the last pose.
  EXPECT_EQ(rpe.at("pairs"), 32);
  for (const char* figure : {"rmse", "mean", "median", "min", "max"}) {
    EXPECT_NEAR(rpe.at("translation_m_per_s").at(figure).get<double>(), 0.5, 1e-6) << figure;
    EXPECT_NEAR(rpe.at("rotation_deg_per_s").at(figure).get<double>(), 0.0, 1e-5) << figure;
  }
}

TEST_F(EvalCommand, TheImagesBesideTheGroundTruthTellHowLongTheRecordingIs) {
  write("rgb.txt", "# color images\n0.1 a.png\n0.3 b.png\n0.7 c.png\n");
  const auto result = eval({groundTruth, trajectory, "--json"});
  EXPECT_NEAR(nlohmann::json::parse(result.out).at("coverage").get<double>(), 0.2 / 0.6, 1e-9);
}

TEST_F(EvalCommand, RefusesBadInput) {
  expectError(eval({groundTruth, folder.path() / "none.txt"}), 1, "none.txt: cannot be opened");
  expectError(eval({write("empty.txt", ""), trajectory}), 1, "empty.txt: holds no pose");
  expectError(eval({groundTruth, write("words.txt", "0.0 1 0 0 0 0 0 1\n0.1 one 0 0 0 0 0 1\n")}), 1, "words.txt:2: ");
  expectError(eval({groundTruth, write("one.txt", "0.0 1 0 0 0 0 0 1\n")}), 1, "there are 1");
  const auto noOverlap = eval({groundTruth, write("later.txt", "9 0 0 0 0 0 0 1\n9.1 1 0 0 0 0 0 1\n")});
  expectError(noOverlap, 1, "there are 0");
  EXPECT_THAT(noOverlap.err, AllOf(HasSubstr("groundtruth.txt and "), HasSubstr("later.txt: ")));
}

TEST_F(EvalCommand, RefusesWrongUsage) {
  expectError(eval({}), 2, "GROUNDTRUTH is required");
  expectError(eval({groundTruth}), 2, "TRAJECTORY is required");
  expectError(eval({groundTruth, "--jsn"}), 2, "unknown option '--jsn'; did you mean '--json'?");
  expectError(eval({groundTruth, trajectory, "third"}), 2, "third");
}

TEST(CommandLine, HelpAndVersionAreNoErrors) {
  const auto help = test::runProgram("wardslam", {"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("Usage: wardslam"), HasSubstr("eval")));
  const auto evalHelp = test::runProgram("wardslam", {"eval", "--help"});
  EXPECT_EQ(evalHelp.exitCode, 0);
  EXPECT_THAT(evalHelp.out, HasSubstr("GROUNDTRUTH"));
  const auto version = test::runProgram("wardslam", {"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_THAT(version.out, ::testing::MatchesRegex("wardslam [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CommandLine, WithoutACommandItListsThem) {
  const auto none = test::runProgram("wardslam", {});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, StartsWith("wardslam: a command is required: run, report, sweep, reproduce, eval, "));
  const auto unknown = test::runProgram("wardslam", {"evaluate", "--json"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(
      unknown.err,
      StartsWith("wardslam: unknown command 'evaluate'; the commands are run, report, sweep, reproduce, eval, "));
  const auto option = test::runProgram("wardslam", {"--versoin"});
  EXPECT_EQ(option.exitCode, 2);
  EXPECT_THAT(option.err, HasSubstr("unknown option '--versoin'; did you mean '--version'?"));
}

}  // namespace
}  // namespace wardslam
