#include "wardslam/reproduction/table.h"

#include <gtest/gtest.h>

#include <limits>

namespace wardslam::reproduction {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(TableText, FiguresAreRoundedAndUnknownOnesADash) {
  EXPECT_EQ(figureText(0.01236, 4), "0.0124");
  EXPECT_EQ(figureText(2.0, 1), "2.0");
  EXPECT_EQ(figureText(kNaN, 4), "–");
}

TEST(TableText, SpreadsTellLeastAndMostAndWhatIsNotKnown) {
  EXPECT_EQ(spreadText(spreadOf({0.0104}), 4), "0.0104") << "a single run has no spread";
  EXPECT_EQ(spreadText(spreadOf({0.03, 0.01, 0.02}), 3), "0.020 [0.010–0.030]");
  EXPECT_EQ(spreadText(spreadOf({0.03, 0.01, kNaN}), 3), "0.020 [0.010–0.030] (2 of 3)");
  EXPECT_EQ(spreadText(spreadOf({kNaN, 0.01}), 2), "0.01 (1 of 2)");
  EXPECT_EQ(spreadText(spreadOf({kNaN, kNaN}), 2), "–");
}

TEST(TableText, MarkdownHasColumnsAsWideAsTheirCells) {
  const Table table = {
      "table_9", "Table 9: words", {"Sequence", "δ"}, {{"ward", "–"}, {"corridor 2", "0.02"}}, {"A note."}};
  EXPECT_EQ(toMarkdown(table),
            "## Table 9: words\n\n"
            "| Sequence   | δ    |\n"
            "|------------|------|\n"
            "| ward       | –    |\n"
            "| corridor 2 | 0.02 |\n"
            "\nA note.\n");
}

TEST(TableText, ACollectionSaysWhatIsMissingBeforeItsTables) {
  const Table table = {"t", "Table 9", {"Sequence", "ATE"}, {{"ward", "0.02"}}, {}};
  const std::string tableText = "\n## Table 9\n\n| Sequence | ATE  |\n|----------|------|\n| ward     | 0.02 |\n";
  EXPECT_EQ(toMarkdown(TableCollection{"Rooms", "Two of three.", {}, {table, table}}),
            "# Rooms\n\nTwo of three.\n" + tableText + tableText);
  EXPECT_EQ(toMarkdown(TableCollection{"Rooms", "None.", {"a: missing", "b: failed"}, {table}}),
            "# Rooms\n\nNone.\n\n- a: missing\n- b: failed\n" + tableText);
}

TEST(TableText, CsvQuotesWhatNeedsIt) {
  const Table table = {"t", "T", {"Sequence", "n = 5, δ = 3"}, {{"the \"ward\"", "–"}, {"b", "1"}}, {"A note."}};
  EXPECT_EQ(toCsv(table), "Sequence,\"n = 5, δ = 3\"\n\"the \"\"ward\"\"\",\nb,1\n");
}

}  // namespace
}  // namespace wardslam::reproduction
