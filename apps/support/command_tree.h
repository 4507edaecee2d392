#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace wardslam::apps {

/// A program or one of its commands.
struct Command {
  std::string path;  ///< " map nearest"; empty: the program itself.
  const CLI::App* app = nullptr;
};

/// The program first, each command before its own commands.
[[nodiscard]] std::vector<Command> commandsOf(const CLI::App& app);

/// The names an option can be given as value; none where it takes something else.
[[nodiscard]] std::vector<std::string> choicesOf(const CLI::Option& option);

}  // namespace wardslam::apps
