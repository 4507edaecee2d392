#include <algorithm>
#include <cctype>
#include <sstream>

#include "support/command_tree.h"
#include "support/manual.h"

namespace wardslam::apps {
namespace {

/// Text that troff takes for text.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '\n') {
      out += "\n.br\n";
    } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out += std::string("\\&") + c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string upperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

/// What follows the name of an option: " FILE", " on|off", " [N]"; nothing for a flag.
std::string valueOf(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const auto choices = choicesOf(option);
  const std::string type = option.get_type_name();
  const std::string value = choices.empty() ? type.substr(0, type.find(':')) : joined(choices, "|");
  return option.get_items_expected_min() == 0 ? " [" + value + "]" : " " + value;
}

std::string remarksOn(const CLI::Option& option) {
  std::vector<std::string> remarks;
  if (option.get_required()) remarks.emplace_back("required");
  const bool isOptionalValue = option.get_items_expected_min() == 0;
  if (!option.get_default_str().empty() && !isOptionalValue) remarks.push_back("default " + option.get_default_str());
  for (const CLI::Option* other : option.get_needs()) remarks.push_back("with " + other->get_name());
  for (const CLI::Option* other : option.get_excludes()) remarks.push_back("not with " + other->get_name());
  return remarks.empty() ? "" : " (" + joined(remarks, ", ") + ")";
}

void describe(std::ostream& out, const CLI::Option& option) {
  out << ".TP\n.B " << plain(option.get_name(false, true)) << plain(valueOf(option)) << "\n"
      << plain(option.get_description() + remarksOn(option)) << "\n";
}

void describeAll(std::ostream& out, const CLI::App& app) {
  const auto options = app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
  for (const bool isPositional : {true, false}) {
    for (const CLI::Option* option : options) {
      if (option->get_positional() == isPositional) describe(out, *option);
    }
  }
}

std::string synopsis(const std::string& program, const Command& command) {
  std::string text = ".B " + plain(program + command.path) + "\n[OPTIONS]";
  for (const CLI::Option* option : command.app->get_options()) {
    if (!option->get_positional()) continue;
    text += option->get_required() ? " " + option->get_name(true) : " [" + option->get_name(true) + "]";
  }
  return text + (command.app->get_subcommands({}).empty() ? "\n" : " COMMAND ...\n");
}

}  // namespace

std::string manualPage(const CLI::App& app) {
  const std::string& program = app.get_name();
  const auto commands = commandsOf(app);
  std::ostringstream page;
  page << ".TH " << upperCase(program) << R"( 1 "" ")" << plain(app.version()) << "\" \"User Commands\"\n"
       << ".SH NAME\n"
       << program << " \\- " << plain(app.get_description()) << "\n.SH SYNOPSIS\n"
       << synopsis(program, commands.front()) << ".SH OPTIONS\n";
  describeAll(page, app);
  if (commands.size() > 1) page << ".SH COMMANDS\n";
  for (std::size_t i = 1; i < commands.size(); ++i) {
    page << ".SS " << plain(program + commands[i].path) << "\n"
         << plain(commands[i].app->get_description()) << "\n.P\n"
         << synopsis(program, commands[i]);
    describeAll(page, *commands[i].app);
  }
  page << ".SH EXIT STATUS\n0: good; 1: failed, one sentence on standard error says why; 2: wrong usage.\n";
  return page.str();
}

}  // namespace wardslam::apps
