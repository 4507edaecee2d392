#include "class_names.h"

#include <gmock/gmock.h>

namespace wardslam::segmentation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ClassNames, StandInDictionariesAndLists) {
  EXPECT_THAT(parseClassNames("{0: 'person', 1: 'iv stand'}"), ElementsAre("person", "iv stand"));
  EXPECT_THAT(parseClassNames("{0: \"nurse's trolley\", 2: 'bed'}"), ElementsAre("nurse's trolley", "", "bed"));
  EXPECT_THAT(parseClassNames("{0: 'a \\'b\\''}"), ElementsAre("a 'b'"));
  EXPECT_THAT(parseClassNames("['person', 'bed']"), ElementsAre("person", "bed"));
  EXPECT_THAT(parseClassNames(R"({"0": "person", "1": "bed"})"), ElementsAre("person", "bed"));
}

TEST(ClassNames, AreNoneInOtherText) {
  for (const char* text : {"", "person", "{", "{a: b}", "{-1: b}", "{99999999: b}", "[[1]]"}) {
    EXPECT_THAT(parseClassNames(text), IsEmpty()) << text;
  }
}

}  // namespace
}  // namespace wardslam::segmentation
