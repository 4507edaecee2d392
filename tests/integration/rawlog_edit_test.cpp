#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli_test_support.h"
#include "room_recording.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kImages = 4;

/// MRPT's own program on rawlogs that rawlog-annotate wrote.
class RawlogEdit : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v rawlog-edit > /dev/null") != 0) {
      GTEST_SKIP() << "rawlog-edit comes with the Debian package mrpt-apps";
    }
    const test::RoomRecording room(kImages);
    const fs::path plain = folder.path() / "plain.rawlog";
    ASSERT_EQ(test::runProgram("tum2rawlog", {room.path().string(), "-o", plain.string()}).exitCode, 0);
    annotate(plain, annotated, room);
    annotate(plain, embedded, room, {"--embed"});
  }

  void annotate(const fs::path& from, const fs::path& to, const test::RoomRecording& room,
                const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {from.string(), "-o", to.string(), "--masks", room.masks().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = test::runProgram("rawlog-annotate", arguments);
    ASSERT_EQ(result.exitCode, 0) << result.err;
  }

  /// What it prints.
  [[nodiscard]] std::string edit(const fs::path& file, const std::string& options) const {
    const fs::path log = folder.path() / "log";
    const std::string command = "rawlog-edit -i " + file.string() + " " + options + " > " + log.string() + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << test::readText(log);
    return test::readText(log);
  }

  /// "--info" tells a sensor as "RGBD / 4 / rate".
  static std::string sensorLine(const std::string& label, int count) {
    return " " + label + " */ *" + std::to_string(count) + " ";
  }

  const std::string plugin = std::string(" -p ") + WARDSLAM_MRPT_PLUGIN;
  test::TemporaryFolder folder;
  fs::path annotated = folder.path() / "annotated.rawlog";
  fs::path embedded = folder.path() / "embedded.rawlog";
  fs::path edited = folder.path() / "edited.rawlog";
};

TEST_F(RawlogEdit, ReadsTheAnnotatedCopyWithoutThePlugin) {
  EXPECT_THAT(edit(annotated, "--info"), ContainsRegex(sensorLine("RGBD", kImages)));
  EXPECT_THAT(edit(annotated, "--describe"),
              AllOf(HasSubstr("Has confidence data? YES"), HasSubstr("label[0]: 'dynamic'")));
}

TEST_F(RawlogEdit, ReadsWhatIsEmbeddedWithThePlugin) {
  EXPECT_THAT(edit(embedded, "--info" + plugin),
              AllOf(ContainsRegex(sensorLine("RGBD", kImages)), ContainsRegex(sensorLine("RGBD_SEM", kImages))));
  EXPECT_THAT(edit(embedded, "--describe" + plugin), HasSubstr("person, confidence"));
  EXPECT_THAT(edit(embedded, "--info"), Not(ContainsRegex(sensorLine("RGBD", kImages))));  // it ends early without
}

TEST_F(RawlogEdit, CutsAndKeepsLabelsWithThePlugin) {
  static_cast<void>(edit(annotated, "--remove-label RGBD -o " + edited.string()));
  if (edit(edited, "--info").find(" RGBD ") != std::string::npos) {
    GTEST_SKIP() << "this rawlog-edit keeps what it says it removed (findings/rawlog-edit-keeps-removed.sh)";
  }
  fs::remove(edited);
  static_cast<void>(edit(embedded, "--cut --from-index 4 --to-index 100 -o " + edited.string() + plugin));
  // Two notes of tum2rawlog and one pair were before.
  EXPECT_THAT(edit(edited, "--info" + plugin), ContainsRegex(sensorLine("RGBD_SEM", kImages - 1)));
  fs::remove(edited);
  static_cast<void>(edit(embedded, "--keep-label RGBD_SEM -o " + edited.string() + plugin));
  EXPECT_THAT(edit(edited, "--info" + plugin),
              AllOf(ContainsRegex(sensorLine("RGBD_SEM", kImages)), Not(ContainsRegex(sensorLine("RGBD", kImages)))));
}

TEST_F(RawlogEdit, ReadsWhatRawlogCutLeaves) {
  const auto cut = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {embedded.string(), "-o", edited.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = test::runProgram("rawlog-cut", arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.out;
  };
  EXPECT_THAT(cut({"--keep", "RGBD_SEM"}), AllOf(HasSubstr("  RGBD: 0 of 4 obs"), HasSubstr("  RGBD_SEM: 4 of 4 obs")));
  EXPECT_THAT(edit(edited, "--info" + plugin),
              AllOf(ContainsRegex(sensorLine("RGBD_SEM", kImages)), Not(ContainsRegex(sensorLine("RGBD", kImages)))));
  static_cast<void>(cut({"--remove", "RGBD_SEM"}));
  EXPECT_THAT(edit(edited, "--info"), ContainsRegex(sensorLine("RGBD", kImages)));  // no plug-in needed any more
  static_cast<void>(cut({"--from", "+0.001"}));
  EXPECT_THAT(edit(edited, "--info" + plugin), ContainsRegex(sensorLine("RGBD_SEM", kImages - 1)));
}

/// Other options and other wrongs: rawlog_cut tests its parts.
TEST(RawlogCutCommand, SaysWhatItCannotDo) {
  const auto nothing = test::runProgram("rawlog-cut", {"in.rawlog", "-o", "out.rawlog"});
  EXPECT_EQ(nothing.exitCode, 2);
  EXPECT_THAT(nothing.err, HasSubstr("nothing to do; give --from, --to, --keep or --remove"));
  const auto both = test::runProgram("rawlog-cut", {"in.rawlog", "-o", "out.rawlog", "--keep", "a", "--remove", "b"});
  EXPECT_EQ(both.exitCode, 2);
  const auto absent = test::runProgram("rawlog-cut", {"absent.rawlog", "-o", "out.rawlog", "--keep", "a"});
  EXPECT_EQ(absent.exitCode, 1);
  EXPECT_THAT(absent.err, HasSubstr("absent.rawlog"));
}

}  // namespace
}  // namespace wardslam
