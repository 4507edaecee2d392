#include <algorithm>
#include <cctype>
#include <sstream>

#include "support/command_tree.h"
#include "support/manual.h"

namespace wardslam::apps {
namespace {

std::string functionName(const std::string& program) {
  std::string name = "_" + program;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

std::vector<std::string> namesOf(const CLI::Option& option) {
  std::vector<std::string> names;
  if (option.get_group().empty()) return names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

/// One branch of "case $path in" for each command: the words that may follow.
void addWords(std::ostream& out, const Command& command) {
  out << "    \"" << command.path << "\")\n      commands=\"";
  for (const CLI::App* next : command.app->get_subcommands({})) out << " " << next->get_name();
  out << "\"\n      options=\"";
  for (const CLI::Option* option : command.app->get_options()) {
    for (const std::string& name : namesOf(*option)) out << " " << name;
  }
  out << "\"\n      ;;\n";
}

void addChoices(std::ostream& out, const Command& command) {
  for (const CLI::Option* option : command.app->get_options()) {
    const auto choices = choicesOf(*option);
    if (choices.empty()) continue;
    for (const std::string& name : namesOf(*option)) {
      out << "    \"" << command.path << " " << name << "\") choices=\"";
      for (const std::string& choice : choices) out << " " << choice;
      out << "\" ;;\n";
    }
  }
}

}  // namespace

std::string bashCompletion(const CLI::App& app) {
  const auto commands = commandsOf(app);
  const std::string function = functionName(app.get_name());
  std::ostringstream out;
  out << "# bash completion for " << app.get_name() << "; made by the program itself\n"
      << function << "() {\n"
      << "  local word=${COMP_WORDS[COMP_CWORD]} path='' commands='' options='' choices='' i\n"
      << "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      << "    case \"$path ${COMP_WORDS[i]}\" in\n";
  for (std::size_t i = 1; i < commands.size(); ++i) {
    out << "    \"" << commands[i].path << "\") path=\"" << commands[i].path << "\" ;;\n";
  }
  out << "    esac\n  done\n  case \"$path\" in\n";
  for (const Command& command : commands) addWords(out, command);
  out << "  esac\n  case \"$path ${COMP_WORDS[COMP_CWORD - 1]}\" in\n";
  for (const Command& command : commands) addChoices(out, command);
  out << "  esac\n"
      << "  if [[ -n $choices ]]; then\n    COMPREPLY=($(compgen -W \"$choices\" -- \"$word\"))\n"
      << "  elif [[ $word == -* ]]; then\n    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
      << "  else\n    COMPREPLY=($(compgen -W \"$commands\" -- \"$word\"))\n  fi\n}\n"
      << "complete -o default -F " << function << " " << app.get_name() << "\n";
  return out.str();
}

}  // namespace wardslam::apps
