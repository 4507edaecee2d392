#include "support/table.h"

#include <gtest/gtest.h>

#include <sstream>

namespace wardslam::apps {
namespace {

std::string text(const Table& table) {
  std::ostringstream out;
  table.print(out);
  return out.str();
}

TEST(Table, ColumnsAreAsWideAsTheirWidestCellAndNumbersStandToTheRight) {
  Table table({"id", "class", "m"});
  table.add({"7", "chair", "-1.50"});
  table.add({"12", "bed", "10.25"});
  EXPECT_EQ(text(table),
            "id  class      m\n"
            " 7  chair  -1.50\n"
            "12  bed    10.25\n");
}

TEST(Table, EmptyCellsTakePartAndLeaveNoBlanksAtTheEnd) {
  Table table({"change", "to"});
  table.add({"gone", ""});
  table.add({"new", "1.0 2.0"});
  EXPECT_EQ(text(table),
            "change  to\n"
            "gone\n"
            "new     1.0 2.0\n");
}

TEST(Table, HeadingsStandAlone) { EXPECT_EQ(text(Table({"id", "class"})), "id  class\n"); }

TEST(Fixed, KeepsItsDigits) { EXPECT_EQ(fixed(1.0 / 3.0, 2), "0.33"); }

}  // namespace
}  // namespace wardslam::apps
