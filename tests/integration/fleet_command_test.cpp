#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include "integration/cli_test_support.h"
#include "support/database_server.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

using testing::HasSubstr;

/// One server, and the ward pushed to it.
class FleetCommandTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!DatabaseServer::whyNot().empty()) return;
    server_ = std::make_unique<DatabaseServer>();
    (void)server_->make("hospital");
    EXPECT_EQ(runProgram("wardslam", {"fleet", "init", "--database", server_->url("hospital")}).exitCode, 0);
  }
  static void TearDownTestSuite() { server_.reset(); }

  void SetUp() override {
    if (const auto why = DatabaseServer::whyNot(); !why.empty()) GTEST_SKIP() << why;
    write(ward_);
    ASSERT_EQ(fleet({"push", path_, "--robot", "robot 1", "--name", "ward"}).err, "");
  }

  void write(const mapping::SemanticMap& map) const {
    (void)storage::MapFile::create(path_, {map.labels, ""}, storage::everythingOf(map));
  }

  static std::vector<std::string> command(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "fleet");
    arguments.insert(arguments.end(), {"--database", server_->url("hospital")});
    return arguments;
  }
  static CommandResult fleet(const std::vector<std::string>& arguments) {
    return runProgram("wardslam", command(arguments));
  }

  /// What the file is told, and what the database is told.
  void expectSameAnswer(std::vector<std::string> question) const {
    std::vector<std::string> ofFile = question;
    ofFile.insert(ofFile.begin(), "map");
    ofFile.insert(ofFile.begin() + 2, path_);
    question.insert(question.begin(), "ask");
    const auto expected = runProgram("wardslam", ofFile);
    const auto answer = fleet(question);
    EXPECT_EQ(answer.err, "");
    EXPECT_NE(expected.out, "");
    EXPECT_EQ(answer.out, expected.out) << testing::PrintToString(question);
  }

  /// `condition`: on those who are connected to the database.
  static void waitUntil(const std::string& condition) {
    for (int look = 0; look < 600; ++look) {
      const auto isSo = server_->sql("hospital", "SELECT " + condition +
                                                     " FROM pg_stat_activity WHERE datname = 'hospital' AND pid <> "
                                                     "pg_backend_pid() AND backend_type = 'client backend'");
      if (isSo == "t") return;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    FAIL() << "never " << condition;
  }

  static inline std::unique_ptr<DatabaseServer> server_;
  TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "ward.wardmap").string();
  mapping::SemanticMap ward_ = makeWard();
};

TEST_F(FleetCommandTest, AnswersAreThoseOfTheFile) {
  expectSameAnswer({"objects"});
  expectSameAnswer({"objects", "--state", "any", "--json"});
  expectSameAnswer({"objects", "--class", "chair", "--zone", "clean zone", "--free", "--json"});
  expectSameAnswer({"objects", "--box", "0.2", "-1", "0", "3.8", "1", "1", "--json"});
  expectSameAnswer({"nearest", "chair", "2.5", "0.4", "--floor", "--json"});
  expectSameAnswer({"at", "2", "2", "0.5", "--json"});
  expectSameAnswer({"zones", "--json"});
  expectSameAnswer({"rooms", "--json"});
  expectSameAnswer({"objects", "--room", "clean zone", "--json"});
}

TEST_F(FleetCommandTest, PullGivesTheBytesThatWerePushed) {
  const std::string pulled = (folder_.path() / "pulled.wardmap").string();
  const auto result = fleet({"pull", "-o", pulled, "--storey", "0"});
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("map 'ward' of robot 'robot 1', site 'main', storey '0'"));
  EXPECT_EQ(readText(pulled), readText(path_));
  EXPECT_THAT(fleet({"pull", "-o", pulled, "--storey", "9"}).err, HasSubstr("no map of storey '9' was pushed yet"));
}

TEST_F(FleetCommandTest, HistoryTellsWhereAThingWas) {
  const auto result = fleet({"history", "--object", "5", "--class", "bed", "--at", "1970-01-01 00:16"});
  EXPECT_EQ(result.out,
            "thing   robot    map   seen there (UTC)     last                 then  place [m]       zone  room    to\n"
            "bed #5  robot 1  ward  1970-01-01 00:15:00  1970-01-01 00:16:39        5.50 3.00 0.40  ward  room 1\n");
  EXPECT_EQ(fleet({"history", "--object", "5", "--at", "noon"}).exitCode, 2);
  EXPECT_EQ(fleet({"history"}).exitCode, 2);
}

TEST_F(FleetCommandTest, WatchEndsCleanlyOnCtrlC) {
  RunningProgram watching("wardslam", command({"watch", "--robot", "robot 9"}));
  waitUntil("count(*) = 1 AND min(query) LIKE 'LISTEN%'");
  write(ward_);
  EXPECT_EQ(fleet({"push", path_, "--robot", "robot 9", "--site", "watched"}).err, "");
  waitUntil("count(*) = 1 AND min(query) NOT LIKE 'LISTEN%' AND min(state) = 'idle'");  // has asked what changed
  watching.send(SIGINT);
  const auto result = watching.wait();
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out, HasSubstr("1970-01-01 00:15:00 new bed #5 in ward (robot 9, ward)\n"));
}

}  // namespace
}  // namespace wardslam::test
