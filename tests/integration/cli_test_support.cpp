#include "cli_test_support.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace wardslam::test {
namespace {

std::vector<char*> toArgv(std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return argv;
}

/// Standard output and error go to these files, input is empty.
pid_t start(std::vector<std::string> words, const std::filesystem::path& out, const std::filesystem::path& err) {
  posix_spawn_file_actions_t redirections;
  posix_spawn_file_actions_init(&redirections);
  constexpr int kCreate = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&redirections, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&redirections, STDOUT_FILENO, out.c_str(), kCreate, 0600);
  posix_spawn_file_actions_addopen(&redirections, STDERR_FILENO, err.c_str(), kCreate, 0600);

  pid_t pid = 0;
  const std::vector<char*> argv = toArgv(words);
  const int error = posix_spawn(&pid, argv.front(), &redirections, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&redirections);
  if (error != 0) throw std::runtime_error("cannot start " + words.front());
  return pid;
}

int waitFor(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("cannot wait for the program");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

RunningProgram::RunningProgram(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {(std::filesystem::path(WARDSLAM_BIN_DIR) / program).string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  pid_ = start(std::move(words), folder_.path() / "stdout", folder_.path() / "stderr");
}

RunningProgram::~RunningProgram() {
  if (pid_ == 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void RunningProgram::send(int signal) const { kill(pid_, signal); }

void RunningProgram::limitFiles(std::optional<std::uint64_t> bytes) const {
  rlimit limit{};
  if (prlimit(pid_, RLIMIT_FSIZE, nullptr, &limit) != 0) throw std::runtime_error("the program has no limits");
  limit.rlim_cur = bytes ? static_cast<rlim_t>(*bytes) : limit.rlim_max;
  if (prlimit(pid_, RLIMIT_FSIZE, &limit, nullptr) != 0) throw std::runtime_error("limits cannot be set");
}

CommandResult RunningProgram::wait() {
  CommandResult result;
  result.exitCode = waitFor(std::exchange(pid_, 0));
  result.out = readText(folder_.path() / "stdout");
  result.err = readText(folder_.path() / "stderr");
  return result;
}

CommandResult runProgram(const std::string& program, const std::vector<std::string>& arguments) {
  return RunningProgram(program, arguments).wait();
}

}  // namespace wardslam::test
