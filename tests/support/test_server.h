#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace wardslam::test {

/// A web server on this computer, see test_server.py; ends with this object.
class TestServer {
 public:
  TestServer() {
    setenv("no_proxy", "127.0.0.1", 1);  // of the computer the tests run on
    std::filesystem::create_directories(files());
    std::filesystem::create_directories(state());
    const std::string command =
        "exec python3 '" WARDSLAM_TEST_SERVER "' '" + files().string() + "' '" + state().string() + "'";
    process_ = popen(command.c_str(), "w");
    for (int tries = 0; process_ != nullptr && tries < 1000; ++tries) {
      port_ = readText(state() / "port");
      if (!port_.empty()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    throw std::runtime_error("the test server does not start");
  }
  ~TestServer() { pclose(process_); }
  TestServer(const TestServer&) = delete;
  TestServer& operator=(const TestServer&) = delete;

  /// Puts a file on the server.
  void add(const std::string& name, const std::string& content) const { (void)folder_.write("files/" + name, content); }
  [[nodiscard]] std::string url(const std::string& path) const { return "http://127.0.0.1:" + port_ + "/" + path; }

  /// The Range header of every request so far; "-" without one.
  [[nodiscard]] std::vector<std::string> requests() const {
    std::vector<std::string> ranges;
    std::istringstream lines(readText(state() / "requests"));
    for (std::string line; std::getline(lines, line);) ranges.push_back(line);
    return ranges;
  }

 private:
  [[nodiscard]] std::filesystem::path files() const { return folder_.path() / "files"; }
  [[nodiscard]] std::filesystem::path state() const { return folder_.path() / "state"; }

  TemporaryFolder folder_;
  std::FILE* process_ = nullptr;
  std::string port_;
};

}  // namespace wardslam::test
