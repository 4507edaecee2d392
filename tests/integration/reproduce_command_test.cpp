#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli_test_support.h"
#include "room_recording.h"
#include "support/test_server.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Arguments = std::vector<std::string>;

const fs::path kData = fs::path(WARDSLAM_SHARED_DIR) / "data";

class ReproduceCommand : public ::testing::Test {
 protected:
  [[nodiscard]] Arguments argumentsOf(const fs::path& plan, const Arguments& more = {}) const {
    Arguments arguments = {"reproduce", plan, "--data", room.path().parent_path(), "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  [[nodiscard]] test::CommandResult reproduce(const std::string& yaml, const Arguments& more = {}) const {
    return test::runProgram("wardslam", argumentsOf(folder.write("plan.yaml", yaml), more));
  }
  /// A plan with one sequence that is there and one that is not.
  [[nodiscard]] std::string plan(const std::string& more = {}) const {
    return more +
           "variants:\n  - {name: without, filter: \"off\"}\n  - {name: ours}\nsequences:\n  - {name: room, folder: " +
           room.path().filename().string() + ", masks: masks}\n  - {name: elsewhere, folder: not_here_at_all}\n";
  }
  [[nodiscard]] fs::path cell(const std::string& name) const { return out / "cells" / "room" / name; }
  [[nodiscard]] std::string tables() const { return test::readText(out / "tables.md"); }

  test::TemporaryFolder folder;
  test::RoomRecording room{6};
  const fs::path out = folder.path() / "out";
};

TEST_F(ReproduceCommand, WritesTablesAndSaysWhatIsMissing) {
  const auto result = reproduce(plan("title: Rooms\nrepetitions: 2\n"));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, tables());
  EXPECT_THAT(tables(), StartsWith("# Rooms\n"));
  EXPECT_THAT(tables(),
              AllOf(HasSubstr("4 of 8 runs are done, 4 cannot be"), HasSubstr("elsewhere: missing, looked for in "),
                    HasSubstr("Table 1: "), HasSubstr("Table 2: "), HasSubstr("Table 3: "), HasSubstr("Table 4: "),
                    HasSubstr("Table 7: ")));
  const auto evaluation = nlohmann::json::parse(test::readText(cell("without/0/result.json"))).at("evaluation");
  char rmse[32];
  std::snprintf(rmse, sizeof rmse, "%.6f", evaluation.at("ate").at("rmse").get<double>());
  EXPECT_THAT(test::readText(out / "figures.csv"), HasSubstr("\nroom,without,ate_rmse_se3,m,"));
  EXPECT_THAT(test::readText(out / "figures.csv"), HasSubstr(rmse)) << "that of the run";
  EXPECT_THAT(test::readText(cell("ours/1/run/config.yaml")), HasSubstr("key_points: 1520"));
  EXPECT_THAT(test::readText(cell("ours/0/run/config.yaml")), HasSubstr("key_points: 1500"));
  EXPECT_THAT(test::readText(out / "table_2.csv"),
              AllOf(StartsWith("Sequence,without SE(3),without Sim(3),ours SE(3),ours Sim(3)\nroom,0.0"),
                    HasSubstr("\nelsewhere,missing,missing,missing,missing\n")));
}

/// In Chromium: wide and narrow, light and dark. Six variants make tables that are wider than any window.
TEST_F(ReproduceCommand, ThePageOfTablesKeepsToItsWindow) {
  std::string yaml = "max_frames: 2\nvariants:\n";
  for (const char* name : {"one", "two", "three", "four", "five", "six"}) {
    yaml += std::string("  - {name: the variant of number ") + name + ", filter: \"off\"}\n";
  }
  yaml += "sequences:\n  - {name: room, folder: " + room.path().filename().string() +
          "}\n  - {name: elsewhere, folder: not_here_at_all}\n";
  ASSERT_EQ(reproduce(yaml).exitCode, 0);
  const std::string page = test::readText(out / "tables.html");
  EXPECT_THAT(page, AllOf(HasSubstr("6 of 12 runs are done"), HasSubstr("<li>elsewhere: missing"),
                          HasSubstr("<section id=\"table_7\">")));
  const auto looked = test::runProgram("/usr/bin/env", {"python3", WARDSLAM_LOOK_AT_PAGE, out / "tables.html"});
  if (looked.exitCode == 77) GTEST_SKIP() << looked.err;
  ASSERT_EQ(looked.exitCode, 0) << looked.err;
  const auto looks = nlohmann::json::parse(looked.out);
  ASSERT_EQ(looks.size(), 4U);
  for (const auto& look : looks) {
    SCOPED_TRACE(look.dump(1));
    EXPECT_EQ(look["inner_width"], look["width"]);
    EXPECT_TRUE(look["errors"].empty());
    EXPECT_TRUE(look["requests"].empty());
    EXPECT_EQ(look["overflow_px"], 0);
  }
  EXPECT_NE(looks[0]["paper"], looks[1]["paper"]) << "light and dark";
}

TEST_F(ReproduceCommand, DoesNotRunAgainWhatIsFinished) {
  ASSERT_EQ(reproduce(plan()).exitCode, 0);
  const fs::path kept = cell("without/0/run/summary.json");
  const fs::path changed = cell("ours/0/run/summary.json");
  const auto keptAt = fs::last_write_time(kept);
  const auto changedAt = fs::last_write_time(changed);
  fs::remove(cell("ours/0/result.json"));
  ASSERT_EQ(reproduce(plan()).exitCode, 0);
  EXPECT_EQ(fs::last_write_time(kept), keptAt);
  EXPECT_NE(fs::last_write_time(changed), changedAt) << "it was not finished";

  ASSERT_EQ(reproduce(plan("max_frames: 4\n")).exitCode, 0);
  EXPECT_NE(fs::last_write_time(kept), keptAt) << "fewer images are another run";
  const auto shorterAt = fs::last_write_time(kept);
  room.write("groundtruth.txt", test::readText(room.groundTruth()) + "5000 0 0 0 0 0 0 1\n");
  ASSERT_EQ(reproduce(plan("max_frames: 4\n")).exitCode, 0);
  EXPECT_NE(fs::last_write_time(kept), shorterAt) << "another truth is another figure";
}

TEST_F(ReproduceCommand, AnInterruptionKeepsWhatIsFinishedAndLeavesNobodyBehind) {
  const test::RoomRecording endless(6, 20000);
  const std::string yaml =
      plan() + "  - {name: endless, folder: " + endless.path().filename().string() + ", masks: masks}\n";
  const fs::path file = folder.write("plan.yaml", yaml);
  test::RunningProgram program("wardslam", argumentsOf(file, {"--jobs", "2"}));
  const fs::path live = out / "cells/endless/ours/0/run/trajectory_live.txt.partial";
  const auto begun = [&] { return fs::exists(live) && fs::exists(cell("ours/0/result.json")); };
  for (int i = 0; i < 6000 && !begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(begun());
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().exitCode, 0);
  EXPECT_FALSE(fs::exists(live)) << "the runs under way have ended";
  EXPECT_THAT(tables(), HasSubstr("2 of 6 runs are done, 2 cannot be")) << "those under way can";
  EXPECT_FALSE(fs::exists(out / "cells/endless/ours/0/result.json")) << "half a run is no result";
}

TEST_F(ReproduceCommand, ARunThatFailsIsToldAndTheOthersGoOn) {
  const fs::path broken = folder.path() / "broken";
  fs::create_directories(broken);
  folder.write("broken/groundtruth.txt", "1 0 0 0 0 0 0 1\n");
  fs::create_directory_symlink(broken, room.path() / "broken");
  const auto result =
      reproduce("variants: [{name: without, filter: \"off\"}]\nsequences:\n  - {name: broken, folder: " +
                room.path().filename().string() +
                "/broken}\n  - {name: room, folder: " + room.path().filename().string() + "}\n");
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(tables(), HasSubstr("- broken, without, repetition 0: wardslam: "));
  EXPECT_TRUE(fs::exists(cell("without/0/result.json")));
}

TEST_F(ReproduceCommand, RefusesABadPlanBeforeAnythingIsRun) {
  const auto expectRefused = [&](const std::string& yaml, const std::string& part) {
    const auto result = reproduce(yaml);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, HasSubstr(part));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(fs::exists(out / "cells"));
  };
  expectRefused("repetition: 2\n" + plan(), "plan.yaml:1: 'repetition': unknown key; did you mean 'repetitions'?");
  expectRefused(plan() + "  - {name: x, camera: none.yaml}\n  - {name: y, folder: " + room.path().filename().string() +
                    ", camera: none.yaml}\n",
                "none.yaml");
  const auto none = test::runProgram("wardslam", {"reproduce", "no_such_plan.yaml", "--out", out});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_THAT(none.err, HasSubstr("no_such_plan.yaml"));
}

TEST_F(ReproduceCommand, PlansThatComeWithTheProgramAreReadWhole) {
  const test::TemporaryFolder empty;
  for (const char* name : {"tum_fr3.yaml", "bonn.yaml", "sample.yaml", "match_outliers.yaml"}) {
    const auto result = test::runProgram("wardslam", {"reproduce", name, "--data", empty.path(), "--out", out / name});
    EXPECT_EQ(result.exitCode, 0) << name << ": " << result.err;
    EXPECT_THAT(result.out, HasSubstr("0 of ")) << name;
  }
  const std::string ours = test::readText(out / "tum_fr3.yaml" / "table_2.csv");
  EXPECT_THAT(ours, HasSubstr("fr3-walking-half,0.1252,0.0489,0.0285,0.3116,0.0923")) << "the paper's Table 2";
  EXPECT_THAT(ours, HasSubstr("missing"));
  EXPECT_THAT(test::readText(out / "bonn.yaml" / "table_2.csv"), HasSubstr("bonn-crowd,"));
}

TEST_F(ReproduceCommand, OfflineTakesOneSentence) {
  const auto result = reproduce(
      "variants: [{name: without, filter: \"off\"}]\nsequences:\n"
      "  - {name: a, folder: not_here_a, fetch: {url: 'http://127.0.0.1:1/a.tgz'}}\n"
      "  - {name: b, folder: not_here_b, fetch: {url: 'http://127.0.0.1:1/b.zip'}}\n",
      {"--fetch"});
  EXPECT_EQ(result.exitCode, 0) << "missing is no error";
  EXPECT_THAT(result.err, AllOf(HasSubstr("is this computer offline?"), Not(HasSubstr("b.zip"))));
  EXPECT_THAT(result.out, HasSubstr("a: missing"));
}

TEST_F(ReproduceCommand, AnInterruptionEndsRendering) {
  const std::string yaml =
      "variants: [{name: without, filter: \"off\"}]\nsequences:\n  - {name: ward, render: --scene ward --seconds "
      "3600}\n";
  test::RunningProgram program(
      "wardslam", {"reproduce", folder.write("plan.yaml", yaml), "--data", folder.path() / "data", "--out", out});
  const fs::path begun = folder.path() / "data/ward.partial/out.txt";
  for (int i = 0; i < 6000 && !fs::exists(begun); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(fs::exists(begun));
  program.send(SIGTERM);
  const auto result = program.wait();
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, Not(HasSubstr("fails")));
  EXPECT_THAT(result.out, HasSubstr("ward: missing"));
  EXPECT_FALSE(fs::exists(folder.path() / "data/ward")) << "half a recording is none";
}

/// A folder as an archive, as sites of benchmarks have them.
std::string archiveOf(const fs::path& folder, const fs::path& scratch) {
  const fs::path archive = scratch / "sequence.tgz";
  const std::string command = "tar -czhf '" + archive.string() + "' -C '" + folder.parent_path().string() + "' '" +
                              folder.filename().string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return test::readText(archive);
}

class ReproduceFetch : public ReproduceCommand {
 protected:
  ReproduceFetch() { server_.add("room.tgz", archiveOf(room.path(), folder.path())); }
  [[nodiscard]] std::string plan(const std::string& more = {}) const {
    return "max_frames: 3\nvariants: [{name: without, filter: \"off\"}]\nsequences:\n  - {name: room, folder: fetched, "
           "fetch: {url: '" +
           server_.url("room.tgz") + "'" + more + "}}\n";
  }
  [[nodiscard]] test::CommandResult fetch(const std::string& yaml, const Arguments& more = {"--fetch"}) const {
    Arguments arguments = {"reproduce", folder.write("plan.yaml", yaml), "--data", data(), "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::runProgram("wardslam", arguments);
  }
  [[nodiscard]] fs::path data() const { return folder.path() / "data"; }

  test::TestServer server_;
};

TEST_F(ReproduceFetch, GetsWhatIsMissingOnRequestOnlyAndOnce) {
  EXPECT_THAT(fetch(plan(), {}).out, HasSubstr("room: missing"));
  EXPECT_TRUE(server_.requests().empty());
  const auto result = fetch(plan());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("1 of 1 runs are done."), Not(HasSubstr("missing"))));
  EXPECT_TRUE(fs::exists(data() / "fetched" / "rgb.txt"));
  EXPECT_EQ(std::distance(fs::directory_iterator(data()), fs::directory_iterator()), 1) << "no archive, no scraps";
  const std::size_t requests = server_.requests().size();
  EXPECT_EQ(fetch(plan()).exitCode, 0);
  EXPECT_EQ(server_.requests().size(), requests);
}

TEST_F(ReproduceFetch, GoesOnWithWhatWasDownloaded) {
  const std::string whole = test::readText(folder.path() / "sequence.tgz");
  folder.write("data/room.tgz.partial", whole.substr(0, 1000));
  const auto result = fetch(plan(", size_bytes: " + std::to_string(whole.size())));
  EXPECT_THAT(result.out, HasSubstr("1 of 1 runs are done.")) << result.err;
  EXPECT_EQ(server_.requests(), Arguments{"bytes=1000-"});
}

TEST_F(ReproduceFetch, DoesNotTakeWhatIsNotWhatItShouldBe) {
  const auto refused = [&](const std::string& more, const std::string& part) {
    const auto result = fetch(plan(more));
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, HasSubstr(part));
    EXPECT_THAT(result.out, HasSubstr("room: missing"));
    EXPECT_TRUE(fs::is_empty(data())) << "nothing of it stays";
  };
  refused(", size_bytes: 7", "where room.tgz has 7");
  refused(", sha256: " + std::string(64, 'a'), "sha256");
  server_.add("room.tgz", "no archive at all");
  refused("", "is no whole archive");
}

TEST_F(ReproduceCommand, RendersWhatIsAbsent) {
  const std::string yaml =
      "max_frames: 3\nvariants: [{name: ours}]\nsequences:\n  - {name: ward, folder: ward, masks: "
      "../ward_labels/masks, "
      "render: --scene ward --width 160 --height 120 --rate 4 --seconds 2}\n";
  const Arguments arguments = {"reproduce", folder.write("plan.yaml", yaml), "--data", folder.path() / "data", "--out",
                               out};
  const auto result = test::runProgram("wardslam", arguments);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("ward: is rendered by rawlog-synth --scene ward"));
  EXPECT_THAT(result.out, HasSubstr("1 of 1 runs are done."));
  EXPECT_FALSE(fs::exists(folder.path() / "data/ward.partial"));
  EXPECT_EQ(test::runProgram("wardslam", arguments).err, "") << "once";
}

TEST(ReproduceSample, ShowsThatTheFiltersDoWhatTheyAreFor) {
  if (!fs::exists(kData / "ward_walking")) GTEST_SKIP() << "not here: " << (kData / "ward_walking");
  const test::TemporaryFolder folder;
  const auto result =
      test::runProgram("wardslam", {"reproduce", "sample.yaml", "--data", kData, "--out", folder.path() / "out"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("24 of 24 runs are done."), HasSubstr("Table 5: "), HasSubstr("Table 6: ")));
  double off = 0.0;
  double ours = 0.0;
  std::istringstream lines(test::readText(folder.path() / "out" / "figures.csv"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<std::string> words;
    for (std::string word; std::getline(cells, word, ',');) words.push_back(word);
    if (words.at(0) != "rpy_walk" || words.at(2) != "ate_rmse_se3") continue;
    if (words.at(1) == "filter off") off = std::stod(words.at(4));
    if (words.at(1) == "ours") ours = std::stod(words.at(4));
  }
  EXPECT_GT(off, 3.0 * ours) << "the man who walks close by pulls the camera along";
  EXPECT_GT(ours, 0.0);
  EXPECT_LT(ours, 0.02);
}

}  // namespace
}  // namespace wardslam
