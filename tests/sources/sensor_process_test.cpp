#include "sensor_process.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::StartsWith;
using ::testing::ThrowsMessage;

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

/// The first line of what the program says.
std::string readLine(const SensorProcess& process) {
  std::string line;
  for (char c = 0; read(process.output(), &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

bool isRunning(pid_t pid) { return kill(pid, 0) == 0; }

TEST(SensorProcess, IsHeard) {
  const SensorProcess process(shell("echo hello"));
  EXPECT_EQ(readLine(process), "hello");
}

TEST(SensorProcess, TellsHowItEnded) {
  EXPECT_EQ(SensorProcess(shell("exit 3")).howItEnded(), "ended with exit code 3");
  EXPECT_EQ(SensorProcess(shell("kill -ABRT $$")).howItEnded(), "ended with signal 6 (Aborted)");
}

TEST(SensorProcess, IsAskedToEndByItsInput) {
  const test::TemporaryFolder folder;
  const auto farewell = folder.path() / "farewell";
  { const SensorProcess process(shell("cat; echo closed > " + farewell.string())); }
  EXPECT_EQ(test::readText(farewell), "closed\n");
}

TEST(SensorProcess, IsKilledWhenItDoesNotEnd) {
  pid_t pid = 0;
  {
    const SensorProcess process(shell("echo $$; trap '' TERM; while :; do sleep 60; done"));
    pid = std::stoi(readLine(process));
    EXPECT_TRUE(isRunning(pid));
  }
  EXPECT_FALSE(isRunning(pid));
}

TEST(SensorProcess, SaysWhenItCannotBeStarted) {
  EXPECT_THAT([] { SensorProcess({"/no/such/program"}); },
              ThrowsMessage<core::InputError>(StartsWith("/no/such/program: cannot be started (No such file")));
}

}  // namespace
}  // namespace wardslam::sources
