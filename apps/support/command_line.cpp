#include "support/command_line.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "support/manual.h"
#include "support/program.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::apps {
namespace {

std::string listCommands(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

std::string nearestOption(const CLI::App& app, const std::string& option) {
  std::vector<std::string> names;
  for (const CLI::Option* known : app.get_options()) {
    for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
  }
  return core::nearestName(option, names);
}

/// `named`: what the words after the program's name led to, the app itself or one of its commands.
std::string explainUnknown(const std::string& word, const CLI::App& app, const CLI::App& named) {
  if (word.front() == '-') {
    const std::string option = word.substr(0, word.find('='));
    return "unknown option '" + option + "'; did you mean '" + nearestOption(named, option) + "'?";
  }
  const bool isCommand = &named == &app && !app.get_subcommands({}).empty();
  return isCommand ? "unknown command '" + word + "'; the commands are " + listCommands(app)
                   : "unexpected argument '" + word + "'";
}

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands();
  const CLI::App& named = commands.empty() ? app : *commands.front();
  const std::string help = " (see " + app.get_name() + (&named == &app ? "" : " " + named.get_name()) + " --help)";

  const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  const bool isMissing = code == CLI::ExitCodes::RequiredError;  // perhaps because its name was misspelt
  const auto unknown = app.remaining(true);
  if ((isMissing || code == CLI::ExitCodes::ExtrasError) && !unknown.empty() && !unknown.front().empty()) {
    return explainUnknown(unknown.front(), app, named) + help;
  }
  if (isMissing && commands.empty() && !app.get_subcommands({}).empty()) {
    return "a command is required: " + listCommands(app) + help;
  }
  return error.what() + help;
}

int generate(const CLI::App& app, const std::string& what) {
  if (what == "man") {
    std::cout << manualPage(app);
  } else if (what == "bash-completion") {
    std::cout << bashCompletion(app);
  } else {
    throw UsageError("--generate: '" + what + "' is neither man nor bash-completion");
  }
  return kSuccess;
}

}  // namespace

std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--generate") return generate(app, argv[2]);
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError(explain(app, error));
    return app.exit(error);
  }
}

}  // namespace wardslam::apps
