#include "support/command_tree.h"

#include <sstream>

namespace wardslam::apps {
namespace {

void collect(const CLI::App& app, const std::string& path, std::vector<Command>& commands) {
  commands.push_back({path, &app});
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_name().empty()) collect(*command, path + " " + command->get_name(), commands);
  }
}

}  // namespace

std::vector<Command> commandsOf(const CLI::App& app) {
  std::vector<Command> commands;
  collect(app, "", commands);
  return commands;
}

// CLI11 tells them as part of the type: "TEXT:{on,off}", "ENUM:value in {ward->0,floor->1} OR {0,1}".
std::vector<std::string> choicesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{');
  const auto end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::vector<std::string> choices;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice.substr(0, choice.find("->")));
  return choices;
}

}  // namespace wardslam::apps
