#include "wardslam/core/text_lines.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

TEST(TextLines, KeepTheirNumbersAndLoseMarksAndEnds) {
  const test::TemporaryFolder folder;
  const auto lines = readTextLines(folder.write("list.txt", "\xEF\xBB\xBF# remark\r\n\r\n  \t\r\n 1 a \r\n2 b"));
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_TRUE(lines[0].isRemark);
  EXPECT_EQ(lines[0].text, "# remark");
  EXPECT_EQ(lines[1].number, 4);
  EXPECT_EQ(lines[1].text, "1 a");
  EXPECT_EQ(lines[2].number, 5);
  EXPECT_FALSE(lines[2].isRemark);
}

TEST(TextLines, OfUtf16AreNamed) {
  const test::TemporaryFolder folder;
  const std::string bigEndian("\xFE\xFF\0001\0 ", 6);
  const std::string unmarked("1\0 \0", 4);
  for (const std::string& text : {bigEndian, unmarked}) {
    EXPECT_THAT([&] { (void)readTextLines(folder.write("list.txt", text)); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("list.txt"), HasSubstr("UTF-16"), HasSubstr("iconv"))));
  }
}

TEST(TextLines, MustBeThere) {
  const test::TemporaryFolder folder;
  for (const auto& path : {folder.path() / "none.txt", folder.path()}) {
    EXPECT_THAT([&] { (void)readTextLines(path); }, ThrowsMessage<InputError>(HasSubstr("cannot be opened")));
  }
}

TEST(Words, StandBetweenSeparatorsOrInQuotes) {
  EXPECT_THAT(wordsIn(" 1.5,rgb/a.png;\t2.5  \"a file, with blanks.png\"\r"),
              ElementsAre("1.5", "rgb/a.png", "2.5", "a file, with blanks.png"));
  EXPECT_THAT(wordsIn("\"unfinished a"), ElementsAre("\"unfinished", "a"));
  EXPECT_THAT(wordsIn(" ,; "), IsEmpty());
}

}  // namespace
}  // namespace wardslam::core
