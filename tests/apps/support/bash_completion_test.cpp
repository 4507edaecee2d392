#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <map>

#include "support/command_tree.h"
#include "support/manual.h"

namespace wardslam::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// tests/manual/check_manual.py lets bash itself complete the words of all programs.

TEST(BashCompletion, KnowsTheWordsOfEveryCommand) {
  CLI::App app("", "nurse-call");
  app.add_subcommand("ring", "")->add_flag("-l,--loud", "");
  const std::string script = bashCompletion(app);
  EXPECT_THAT(script, HasSubstr("    \"\")\n      commands=\" ring\"\n      options=\" --help -h\"\n"));
  EXPECT_THAT(script, HasSubstr("    \" ring\")\n      commands=\"\"\n      options=\" --help -h --loud -l\"\n"));
  EXPECT_THAT(script, HasSubstr("complete -o default -F _nurse_call nurse-call\n"));
}

TEST(BashCompletion, ProposesNamesToChooseFrom) {
  CLI::App app("", "bell");
  std::string tone;
  app.add_option("--tone", tone, "")->check(CLI::IsMember({"high", "low"}));
  EXPECT_THAT(bashCompletion(app), HasSubstr("\" --tone\") choices=\" high low\" ;;\n"));
}

TEST(ChoicesOf, AreTheNamesAnOptionKnows) {
  enum class Tone { High, Low };
  CLI::App app;
  Tone tone = Tone::High;
  std::string file;
  const std::map<std::string, Tone> names = {{"high", Tone::High}, {"low", Tone::Low}};
  EXPECT_THAT(choicesOf(*app.add_option("--tone", tone, "")->transform(CLI::CheckedTransformer(names))),
              ElementsAre("high", "low"));
  EXPECT_THAT(choicesOf(*app.add_option("--file", file, "")), IsEmpty());
}

}  // namespace
}  // namespace wardslam::apps
