#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli_test_support.h"

namespace wardslam::test {

inline constexpr int kImages = 12;

/// `wardslam run`, and what it leaves behind.
class RunCommand : public ::testing::Test {
 protected:
  /// `wardslam run INPUT --out <out> …`
  [[nodiscard]] CommandResult run(const std::filesystem::path& input,
                                  const std::vector<std::string>& more = {"--filter", "off"}) const {
    return runProgram("wardslam", argumentsOf(input, more));
  }
  [[nodiscard]] std::vector<std::string> argumentsOf(const std::filesystem::path& input,
                                                     const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"run", input, "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  [[nodiscard]] nlohmann::json summary() const { return nlohmann::json::parse(readText(out / "summary.json")); }

  /// The poses written, a line each.
  [[nodiscard]] std::vector<std::string> trajectory() const {
    std::istringstream text(readText(out / "trajectory.txt"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
      if (line.front() != '#') lines.push_back(line);
    }
    return lines;
  }

  /// Exit code, nothing on standard output and exactly one sentence on standard error.
  static void expectError(const CommandResult& result, int exitCode, const std::string& part) {
    EXPECT_EQ(result.exitCode, exitCode);
    EXPECT_THAT(result.out, ::testing::IsEmpty());
    EXPECT_THAT(result.err, ::testing::AllOf(::testing::StartsWith("wardslam: "), ::testing::HasSubstr(part),
                                             ::testing::EndsWith("\n")));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }

  /// What could be tracked is on disk in full, and the summary tells what was left out.
  void expectTheRest(std::size_t frames, const std::string& damage) const {
    EXPECT_THAT(trajectory(), ::testing::SizeIs(frames));
    EXPECT_EQ(summary().at("frames"), frames);
    EXPECT_EQ(summary().at("damaged_input").value(damage, 0), 1) << summary();
  }

  TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "results";
};

}  // namespace wardslam::test
