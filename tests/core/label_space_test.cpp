#include "wardslam/core/label_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

using testing::HasSubstr;

LabelSpace readClasses(const std::string& text) {
  const test::TemporaryFolder folder;
  return LabelSpace::cocoWith(folder.write("classes.txt", text));
}

TEST(LabelSpace, NumbersCocoFromOne) {
  const LabelSpace labels = LabelSpace::coco();
  EXPECT_EQ(labels.name(0), "unclassified");
  EXPECT_EQ(labels.name(1), "person");
  EXPECT_EQ(labels.name(57), "chair");
  EXPECT_EQ(labels.name(60), "bed");
  EXPECT_EQ(labels.name(80), "toothbrush");
  EXPECT_EQ(labels.name(81), "");
  EXPECT_EQ(labels.name(255), "");
}

TEST(LabelSpace, FindsIdsByName) {
  const LabelSpace labels = LabelSpace::coco();
  for (int id = 0; id <= 80; ++id) {
    EXPECT_EQ(labels.find(labels.name(static_cast<ClassId>(id))), static_cast<ClassId>(id));
  }
  EXPECT_EQ(labels.find("wheelchair"), std::nullopt);
  EXPECT_EQ(labels.find(""), std::nullopt);
}

TEST(LabelSpace, IsExtendedByAFile) {
  const LabelSpace labels = readClasses("# hospital things\n\n100 wheelchair\r\n101\tIV stand\n1 person\n");
  EXPECT_EQ(labels.name(100), "wheelchair");
  EXPECT_EQ(labels.find("IV stand"), ClassId{101});
  EXPECT_EQ(labels.find("person"), ClassId{1});
}

TEST(LabelSpace, BadLinesAreNamed) {
  const auto says = [](const std::string& text, const std::string& complaint) {
    EXPECT_THAT([&] { return readClasses(text); }, testing::ThrowsMessage<InputError>(HasSubstr(complaint))) << text;
  };
  says("100 trolley\n0 nothing\n", "classes.txt:2: a class id from 1 to 255");
  says("256 trolley\n", "classes.txt:1: a class id from 1 to 255");
  says("trolley\n", "classes.txt:1: a class id from 1 to 255");
  says("100trolley\n", "classes.txt:1: a class id from 1 to 255");
  says("99999999999 trolley\n", "classes.txt:1: a class id from 1 to 255");
  says("100 \n", "classes.txt:1: class 100 has no name");
  says("100 trolley\n101 trolley\n", "classes.txt:2: 'trolley' is the name of class 100 already");
  says("100 trolley\n100 stretcher\n", "classes.txt:2: class 100 is named 'trolley' already");
}

TEST(LabelSpace, AFileOverrulesCoco) {
  const LabelSpace labels = readClasses("1 trolley\n2 person\n");
  EXPECT_EQ(labels.name(1), "trolley");
  EXPECT_EQ(labels.find("person"), ClassId{2});
  EXPECT_EQ(labels.find("bicycle"), std::nullopt);
  EXPECT_EQ(readClasses("100 person\n").name(1), "");
}

TEST(LabelSpace, RenamingMovesAName) {
  LabelSpace labels = LabelSpace::coco();
  labels.rename(100, "chair");
  EXPECT_EQ(labels.find("chair"), ClassId{100});
  EXPECT_EQ(labels.name(57), "");
  labels.rename(100, "chair");
  EXPECT_EQ(labels.find("chair"), ClassId{100});
}

TEST(LabelSpace, MissingFileIsNamed) {
  EXPECT_THAT([] { return LabelSpace::cocoWith("/nowhere/classes.txt"); },
              testing::ThrowsMessage<InputError>(HasSubstr("/nowhere/classes.txt: cannot be opened")));
}

}  // namespace
}  // namespace wardslam::core
