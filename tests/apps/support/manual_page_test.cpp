#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

#include "support/manual.h"

namespace wardslam::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ManualPage : public ::testing::Test {
 protected:
  [[nodiscard]] std::string page() const { return manualPage(app_); }

  CLI::App app_{"Weighs things", "scale"};
  std::string text_;
  double number_ = 0.0;
};

TEST_F(ManualPage, SaysWhatTheProgramIs) {
  app_.set_version_flag("--version", "scale 1.2");
  EXPECT_THAT(page(), HasSubstr(".TH SCALE 1 \"\" \"scale 1.2\""));
  EXPECT_THAT(page(), HasSubstr("scale \\- Weighs things\n"));
}

TEST_F(ManualPage, TellsOptionsWithValueAndRemarks) {
  app_.add_option("-o,--output", text_, "where to")->required();
  app_.add_option("--unit", text_, "of weight")->check(CLI::IsMember({"kg", "lb"}));
  app_.add_option("--zero", number_, "of the scale")->default_val(1.5);
  app_.add_option("--every", number_, "weigh again")->expected(0, 1);
  app_.add_flag("--quiet", "say nothing");
  EXPECT_THAT(page(), HasSubstr(".B \\-o,\\-\\-output TEXT\nwhere to (required)\n"));
  EXPECT_THAT(page(), HasSubstr(".B \\-\\-unit kg|lb\nof weight\n"));
  EXPECT_THAT(page(), HasSubstr(".B \\-\\-zero FLOAT\nof the scale (default 1.5)\n"));
  EXPECT_THAT(page(), HasSubstr(".B \\-\\-every [FLOAT]\nweigh again\n"));
  EXPECT_THAT(page(), HasSubstr(".B \\-\\-quiet\nsay nothing\n"));
}

TEST_F(ManualPage, GoesThroughCommandsOfCommands) {
  auto* inner = app_.add_subcommand("tare", "Begin")->add_subcommand("now", "At once");
  inner->add_option("THING", text_, "what to weigh")->required();
  EXPECT_THAT(page(), HasSubstr(".SS scale tare now\nAt once\n.P\n.B scale tare now\n[OPTIONS] THING\n"));
  EXPECT_THAT(page(), HasSubstr(".B THING TEXT\nwhat to weigh (required)\n"));
}

TEST_F(ManualPage, LeavesHiddenOptionsOut) {
  app_.add_flag("--debug", "for us")->group("");
  EXPECT_THAT(page(), Not(HasSubstr("debug")));
}

TEST_F(ManualPage, TakesTextForText) {
  app_.add_flag("--dots", ".hidden \\ things");
  EXPECT_THAT(page(), HasSubstr("\n\\&.hidden \\e things\n"));
}

}  // namespace
}  // namespace wardslam::apps
