#include "sensor_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using namespace std::chrono_literals;

constexpr auto kGrace = 1s;  ///< For closing a device properly.

struct Pipe {
  int read = -1;
  int write = -1;
};

/// Not seen by other programs this process starts.
Pipe makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw core::InputError(std::string("no pipe: ") + std::strerror(errno));
  return {ends[0], ends[1]};
}

/// Drivers talk much; MRPT's own switch shows it.
bool isVerbose() {
  const char* verbose = std::getenv("MRPT_HWDRIVERS_VERBOSE");
  return verbose != nullptr && std::strcmp(verbose, "0") != 0;
}

/// In a process group of its own, so that Ctrl-C reaches only us, and all of it can be killed.
int spawn(pid_t& pid, std::vector<std::string> command, const Pipe& in, const Pipe& out) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, in.read, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out.write, STDOUT_FILENO);
  if (!isVerbose()) posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawnp(&pid, argv.front(), &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

SensorProcess::SensorProcess(const std::vector<std::string>& command) {
  const Pipe in = makePipe();
  const Pipe out = makePipe();
  fcntl(out.write, F_SETPIPE_SZ, 1 << 20);  // a frame in two or three steps instead of twenty
  const int error = spawn(pid_, command, in, out);
  close(in.read);
  close(out.write);
  input_ = in.write;
  output_ = out.read;
  if (error != 0) {
    close(input_);
    close(output_);
    throw core::InputError(command.front() + ": cannot be started (" + std::strerror(error) +
                           "); it belongs to WardSLAM and grabs from the camera");
  }
}

SensorProcess::~SensorProcess() {
  if (input_ >= 0) close(input_);
  if (!hasEnded(kGrace)) kill();
  close(output_);
}

void SensorProcess::kill() {
  if (pid_ == 0) return;
  ::kill(-pid_, SIGKILL);  // its process group: also what it started
  // A process that is stuck within the kernel outlives even this; it must not hold us up.
  if (!hasEnded(kGrace)) pid_ = 0;
}

std::string SensorProcess::howItEnded() {
  if (!hasEnded(kGrace)) return "closed its output";
  if (WIFSIGNALED(status_)) {
    return "ended with signal " + std::to_string(WTERMSIG(status_)) + " (" + strsignal(WTERMSIG(status_)) + ")";
  }
  return "ended with exit code " + std::to_string(WEXITSTATUS(status_));
}

bool SensorProcess::hasEnded(std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (pid_ != 0) {
    if (waitpid(pid_, &status_, WNOHANG) != 0) {
      pid_ = 0;
    } else if (std::chrono::steady_clock::now() >= deadline) {
      return false;
    } else {
      std::this_thread::sleep_for(5ms);
    }
  }
  return true;
}

}  // namespace wardslam::sources
