// `wardslam run --report`, `wardslam report`, and the page in a browser (docs/report.md).

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "integration/room_recording.h"
#include "integration/run_fixture.h"

namespace wardslam::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ReportCommand : public RunCommand {
 protected:
  /// One run for all tests.
  static void SetUpTestSuite() {
    room_ = std::make_unique<RoomRecording>(kImages);
    results_ = std::make_unique<TemporaryFolder>();
    const auto zones = results_->write("zones.yaml",
                                       "zones:\n  - name: '\"a\" <b> & c'\n"
                                       "    polygon: [[-5, -5], [5, -5], [5, 5], [-5, 5]]\n");
    const auto done = runProgram("wardslam", {"run", room_->path(), "--out", results_->path() / "run", "--masks",
                                              room_->masks(), "--zones", zones, "--pictures", "4", "--report"});
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.err, noFloorIsSeen());
  }
  static void TearDownTestSuite() {
    room_.reset();
    results_.reset();
  }

  void SetUp() override { fs::copy(results_->path() / "run", out, fs::copy_options::recursive); }

  [[nodiscard]] CommandResult report(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"report", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram("wardslam", arguments);
  }
  [[nodiscard]] std::string page() const { return readText(out / "report.html"); }

  static inline std::unique_ptr<RoomRecording> room_;
  static inline std::unique_ptr<TemporaryFolder> results_;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(ReportCommand, IsWrittenAtTheEndOfTheRun) {
  EXPECT_THAT(page(), AllOf(HasSubstr("<dt>frames</dt><dd>12</dd>"), HasSubstr("RMSE (ATE)"),
                            HasSubstr("Every frame has a pose"), HasSubstr("<td>MRPT</td>")));
  EXPECT_EQ(count(page(), "<figure>"), 3U);  // images 0, 4 and 8
  EXPECT_THAT(page(), Not(HasSubstr("class=\"missing\"")));
  const std::string table = readText(out / "frames.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 13);  // with the headings
  EXPECT_EQ(summary()["pictures"], json::parse(R"({"interval": 4, "people_kept": false})"));
}

TEST_F(ReportCommand, MakesTheSamePageOfTheFolder) {
  const std::string atTheEnd = page();
  const auto done = report({"--ground-truth", room_->groundTruth(), "--output", folder.path() / "other.html"});
  EXPECT_EQ(done.exitCode, 0) << done.err;
  EXPECT_THAT(done.out + done.err, IsEmpty());
  EXPECT_EQ(readText(folder.path() / "other.html"), atTheEnd);
}

TEST_F(ReportCommand, TellsWhatIsNotThere) {
  fs::remove(out / "map.wardmap");
  const auto done = report();
  EXPECT_EQ(done.exitCode, 0);
  EXPECT_THAT(done.err, HasSubstr("wardslam: report: map.wardmap is not there"));
  EXPECT_THAT(page(), AllOf(HasSubstr("<li>map.wardmap is not there"), HasSubstr("<li>No true way is given")));
  EXPECT_THAT(page(), AllOf(HasSubstr("class=\"way\" d="), Not(HasSubstr("<image"))));
}

TEST_F(ReportCommand, OfWhatIsNoRunIsOneSentence) {
  const TemporaryFolder empty;
  expectError(runProgram("wardslam", {"report", empty.path()}), 1, "holds nothing of a run");
}

TEST_F(ReportCommand, LeavesOutPicturesThatShowPeople) {
  auto changed = summary();
  changed["pictures"]["people_kept"] = true;
  std::ofstream(out / "summary.json") << changed;
  EXPECT_THAT(report().err, HasSubstr("Pictures are left out"));
  EXPECT_EQ(count(page(), "<figure>"), 0U);
  EXPECT_EQ(report({"--keep-people"}).exitCode, 0);
  EXPECT_EQ(count(page(), "<figure>"), 3U);
}

TEST_F(ReportCommand, OfAPrivateRunNamesNoFolder) {
  fs::remove_all(out);
  ASSERT_EQ(run(room_->path(), {"--masks", room_->masks(), "--private", "--report"}).exitCode, 0);
  EXPECT_THAT(page(), AllOf(HasSubstr("<h1>WardSLAM run</h1>"), Not(HasSubstr(room_->path().string())),
                            Not(HasSubstr(out.string()))));
}

/// In Chromium: wide and narrow, light and dark.
TEST_F(ReportCommand, ShowsEverythingInABrowser) {
  const auto looked = runProgram("/usr/bin/env", {"python3", WARDSLAM_LOOK_AT_PAGE, out / "report.html"});
  if (looked.exitCode == 77) GTEST_SKIP() << looked.err;
  ASSERT_EQ(looked.exitCode, 0) << looked.err;
  const json looks = json::parse(looked.out);
  ASSERT_EQ(looks.size(), 4U);
  for (const auto& look : looks) {
    SCOPED_TRACE(look.dump(1));
    EXPECT_EQ(look["inner_width"], look["width"]);
    EXPECT_THAT(look["errors"], IsEmpty());
    EXPECT_THAT(look["requests"], IsEmpty());
    EXPECT_EQ(look["images"], 4);  // three of the run, and the map's
    EXPECT_EQ(look["loaded_images"], look["images"]);
    EXPECT_EQ(look["overflow_px"], 0);
    EXPECT_EQ(look["drawn_plots"], 3);
    EXPECT_EQ(look["tip"], "zone \"a\" <b> & c\n100.0 m²");
  }
  const auto brightness = [](const json& color) {
    int r = 0, g = 0, b = 0;
    EXPECT_EQ(std::sscanf(color.get<std::string>().c_str(), "rgb(%d, %d, %d)", &r, &g, &b), 3);
    return r + g + b;
  };
  for (const auto& look : looks) {
    EXPECT_EQ(brightness(look["paper"]) < brightness(look["ink"]), look["scheme"] == "dark") << look;
  }
}

}  // namespace
}  // namespace wardslam::test
