#include <gmock/gmock.h>

#include <filesystem>

#include "cli_test_support.h"
#include "room_recording.h"
#include "support/temporary_folder.h"

namespace wardslam::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(DoctorCommand, FindsAllInOrderAndWritesABundleWithoutFolders) {
  const RoomRecording room;
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const fs::path bundle = folder.path() / "bundle.txt";
  ASSERT_EQ(runProgram("wardslam", {"run", room.path(), "--masks", room.masks(), "--out", out}).exitCode, 0);
  const auto result = runProgram("wardslam", {"doctor", "--out", out, "--run", out, "--bundle", bundle});
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("libmrpt-core"), HasSubstr("MB/s"), HasSubstr("16 images segmented"),
                                HasSubstr("comes with the program loads"), Not(HasSubstr("TROUBLE"))));
  const std::string report = readText(bundle);
  EXPECT_THAT(report, AllOf(HasSubstr("What happened"), HasSubstr("self-test: poses in the built-in room"),
                            HasSubstr("\"frames_tracked\": 12"), HasSubstr("class_name"), HasSubstr("keyframes: ")));
  EXPECT_THAT(report, Not(HasSubstr(folder.path().string())));
  EXPECT_THAT(report, Not(HasSubstr(room.path().string())));
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 8) << "nothing is left behind where the disk was tried";
}

TEST(DoctorCommand, TellsByItsExitCodeWhatDoesNotWork) {
  const TemporaryFolder folder;
  const fs::path network = folder.write("broken.onnx", "this is no network");
  const auto result = runProgram("wardslam", {"doctor", "--model", network});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, HasSubstr("TROUBLE  network"));
  EXPECT_THAT(result.err, HasSubstr("1 thing does not work"));
}

}  // namespace
}  // namespace wardslam::test
