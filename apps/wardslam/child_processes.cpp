#include "child_processes.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

constexpr int kCannotBeStarted = 127;

/// After fork() and before exec(): nothing here takes memory.
[[noreturn]] void become(const char* program, char* const* arguments, const char* out, const char* err, pid_t parent) {
  const int outFile = open(out, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const int errFile = open(err, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const int input = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(input, STDIN_FILENO);
  dup2(outFile, STDOUT_FILENO);
  dup2(errFile, STDERR_FILENO);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (getppid() == parent) execvp(program, arguments);  // else it has ended meanwhile
  _exit(kCannotBeStarted);
}

int exitCodeOf(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

}  // namespace

ChildProcesses::~ChildProcesses() {
  askToEnd();
  for (const pid_t process : processes_) waitpid(process, nullptr, 0);
}

pid_t ChildProcesses::start(const std::string& program, const std::vector<std::string>& arguments, const fs::path& out,
                            const fs::path& err) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t self = getpid();
  const pid_t process = fork();
  if (process == 0) become(program.c_str(), pointers.data(), out.c_str(), err.c_str(), self);
  if (process < 0) throw core::InputError(program + ": cannot be started: " + std::strerror(errno));
  processes_.push_back(process);
  return process;
}

std::optional<EndedProcess> ChildProcesses::reap() {
  for (auto it = processes_.begin(); it != processes_.end(); ++it) {
    int status = 0;
    if (waitpid(*it, &status, WNOHANG) != *it) continue;
    const EndedProcess ended{*it, exitCodeOf(status)};
    processes_.erase(it);
    return ended;
  }
  return std::nullopt;
}

void ChildProcesses::askToEnd() const {
  for (const pid_t process : processes_) kill(process, SIGTERM);
}

int runToEnd(const std::string& program, const std::vector<std::string>& arguments, const fs::path& out,
             const fs::path& err, const InterruptionGuard& interruption) {
  ChildProcesses processes;
  (void)processes.start(program, arguments, out, err);
  for (bool isAsked = false; true; std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
    if (const auto ended = processes.reap()) return ended->exitCode;
    if (interruption.requested() && !std::exchange(isAsked, true)) processes.askToEnd();
  }
}

std::string lastLine(const fs::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

std::string thisProgram() { return fs::read_symlink("/proc/self/exe").string(); }

int usableCores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) != 0) return 1;
  return std::max(1, CPU_COUNT(&cores));
}

}  // namespace wardslam::apps
