#include "wardslam/sources/tum_lists.h"

#include <gmock/gmock.h>

#include "sources/tum_folder_writer.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

class ImageLists : public ::testing::Test {
 protected:
  void expectError(const std::string& where, const std::string& what) const {
    EXPECT_THAT([&] { return listImagePairs(folder.path()); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr(where), HasSubstr(what))));
  }
  std::vector<ImagePair> listPairs(double rate_hz = 30.0) {
    return listImagePairs(folder.path(), {rate_hz, [this](const std::string& note) { notes.push_back(note); }});
  }
  test::TemporaryFolder folder;
  std::vector<std::string> notes;
};

TEST_F(ImageLists, AreAssociatedByTime) {
  folder.write("rgb.txt", "# comment\n\n1.00 rgb/a.png\n2.00\trgb/b.png\r\n3.00 rgb/c.png\n");
  folder.write("depth.txt", "1.01 depth/x.png\n2.03 depth/y.png\n2.99 depth/z.png\n");
  const auto pairs = listImagePairs(folder.path());
  ASSERT_THAT(pairs, SizeIs(2));  // b and y are 0.03 s apart
  EXPECT_EQ(pairs[0].color.file, "rgb/a.png");
  EXPECT_EQ(pairs[0].depth.file, "depth/x.png");
  EXPECT_EQ(pairs[1].color.stamp_s, 3.0);
  EXPECT_EQ(pairs[1].depth.stamp_s, 2.99);
  EXPECT_THAT(pairs[1].list.string(), EndsWith("rgb.txt"));
  EXPECT_EQ(pairs[1].line, 5);
}

TEST_F(ImageLists, TakeDecimalCommasWhereBlanksPartTheWords) {
  folder.write("rgb.txt", "1,25 rgb/a.png\n1700000000,75\trgb/b.png\n");
  folder.write("depth.txt", "1.25,depth/x.png\n1700000000.75, depth/y.png\n");
  const auto pairs = listImagePairs(folder.path());
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_EQ(pairs[0].color.stamp_s, 1.25);
  EXPECT_EQ(pairs[1].color.stamp_s, 1700000000.75);
  EXPECT_EQ(pairs[1].color.file, "rgb/b.png");
}

TEST_F(ImageLists, TellOfTwoClocksWhereColourAndDepthHaveTwo) {
  folder.write("rgb.txt", "1700000000.25 rgb/a.png\n");
  folder.write("depth.txt", "1700000000250000000 depth/x.png\n");
  EXPECT_EQ(listPairs().at(0).depth.stamp_s, 1700000000.25);
  EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("depth.txt"), HasSubstr("nanoseconds"))));
  notes.clear();
  folder.write("rgb.txt", "1700000000250000000 rgb/a.png\n");
  static_cast<void>(listPairs());
  EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("rgb.txt"), HasSubstr("nanoseconds"))));
}

TEST_F(ImageLists, AnAssociationFileDecides) {
  folder.write("rgb.txt", "1.0 rgb/a.png\n");
  folder.write("depth.txt", "1.0 depth/x.png\n");
  folder.write("associations.txt", "1.0 rgb/a.png 1.5 depth/y.png\n2.0 rgb/b.png 2.5 depth/z.png\n");
  const auto pairs = listImagePairs(folder.path());
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_EQ(pairs[0].depth.file, "depth/y.png");
  EXPECT_EQ(pairs[1].line, 2);
}

TEST_F(ImageLists, AnAssociationFileMayStandAloneAndNameDepthFirst) {
  folder.write("associations.txt", "1.01 depth/x.png 1.0 rgb/a.png\n2.01 depth/y.png 2.0 rgb/b.png\n");
  const auto pairs = listImagePairs(folder.path());
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_EQ(pairs[0].color.stamp_s, 1.0);
  EXPECT_EQ(pairs[0].color.file, "rgb/a.png");
  EXPECT_EQ(pairs[1].depth.file, "depth/y.png");
}

TEST(ImageListsOfImages, DepthIsKnownByItsSixteenBits) {
  const test::TumFolder folder(1);
  folder.writeImage("d/0.png", test::TumFolder::depthImage(0));
  folder.writeImage("c/0.png", test::TumFolder::colorImage(0));
  folder.write("associations.txt", "1.01 d/0.png 1.0 c/0.png\n");
  EXPECT_EQ(listImagePairs(folder.path()).front().color.file, "c/0.png");
}

TEST_F(ImageLists, AMissingListIsNamed) { expectError("rgb.txt", "cannot be opened"); }

TEST_F(ImageLists, AnEmptyListIsNamed) {
  folder.write("rgb.txt", "# color images\n");
  folder.write("depth.txt", "1.0 depth/x.png\n");
  expectError("rgb.txt", "lists no image");
}

TEST_F(ImageLists, AnEmptyListIsAnErrorEvenBesideAnAssociationFile) {
  folder.write("rgb.txt", "");
  folder.write("associations.txt", "1.0 rgb/a.png 1.0 depth/x.png\n");
  expectError("rgb.txt", "lists no image");
}

TEST_F(ImageLists, AnEmptyDepthListIsNamed) {
  folder.write("rgb.txt", "1.0 rgb/a.png\n");
  folder.write("depth.txt", "");
  expectError("depth.txt", "lists no image");
}

TEST_F(ImageLists, AMalformedLineIsNamedByNumber) {
  folder.write("rgb.txt", "# comment\n1.0 rgb/a.png\n2.0\n");
  expectError("rgb.txt:3:", "found 1 words");
}

TEST_F(ImageLists, AStampMustBeANumber) {
  for (const std::string stamp : {"one", "1.0x", "nan", "-1", "1e999"}) {
    folder.write("rgb.txt", stamp + " rgb/a.png\n");
    expectError("rgb.txt:1:", "'" + stamp + "' is not a time stamp");
  }
}

TEST_F(ImageLists, AreTakenInOrderOfTimeAndEachStampOnce) {
  folder.write("rgb.txt", "2.0 rgb/b.png\n1.0 rgb/a.png\n2.0 rgb/c.png\n");
  folder.write("depth.txt", "1.0 depth/a.png\n2.0 depth/b.png\n");
  const auto pairs = listPairs();
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_EQ(pairs[0].color.file, "rgb/a.png");
  EXPECT_EQ(pairs[1].color.file, "rgb/b.png");
  EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("rgb.txt"), HasSubstr("not in order of time")),
                                 AllOf(HasSubstr("rgb.txt"), HasSubstr("1 images with the stamp of one before"))));
}

/// One line of an association list as other tools write it.
class AssociationLine : public ImageLists {
 protected:
  void expectRead(const std::string& text, const std::string& name = "associations.txt") {
    std::filesystem::remove_all(folder.path());
    std::filesystem::create_directories(folder.path() / "rgb");
    std::filesystem::create_directories(folder.path() / "depth");
    for (const char* file : {"rgb/a.png", "depth/b.png"}) folder.write(file, "");
    folder.write(name, text);
    const auto pairs = listPairs();
    ASSERT_THAT(pairs, SizeIs(1)) << text;
    EXPECT_EQ(pairs[0].color.file.lexically_normal(), "rgb/a.png") << text;
    EXPECT_EQ(pairs[0].depth.file.lexically_normal(), "depth/b.png") << text;
    EXPECT_EQ(pairs[0].color.stamp_s, 1.5) << text;
    EXPECT_EQ(pairs[0].depth.stamp_s, 1.25) << text;
  }
};

TEST_F(AssociationLine, MayBeWrittenInManyWays) {
  const std::string line = "1.5 rgb/a.png 1.25 depth/b.png\n";
  expectRead(line);
  expectRead(line, "associate.txt");
  expectRead(line, "associated.txt");
  expectRead("\xEF\xBB\xBF" + line);
  expectRead("\xEF\xBB\xBF# made by a script\n" + line);
  expectRead("timestamp rgb timestamp depth\n" + line);
  expectRead("1.5,rgb/a.png,1.25,depth/b.png\r\n");
  expectRead("1.5\trgb/a.png;1.25\tdepth/b.png\n");
  expectRead("1.5 \"rgb/a.png\" 1.25 \"depth/b.png\"\n");
  expectRead("1.5 rgb\\a.png 1.25 depth\\b.png\n");
  expectRead("1.5 ./rgb/a.png 1.25 ./depth/b.png\n");
  expectRead("1.5 /home/someone/seq/rgb/a.png 1.25 /home/someone/seq/depth/b.png\n");
  expectRead("+1.5 rgb/a.png +1.25 depth/b.png\n");
  expectRead("1.5 rgb/a.png + 1.25 depth/b.png\n");
  expectRead("rgb/a.png 1.5 depth/b.png 1.25\n");
  expectRead("1.4 0 0 0 0 0 0 1 1.25 depth/b.png 1.5 rgb/a.png\n");
}

TEST_F(ImageLists, KnowOtherNames) {
  folder.write("color.txt", "1.0 color/a.png\n");
  folder.write("aligned_depth.txt", "1.0 aligned_depth/a.png\n");
  const auto pairs = listPairs();
  ASSERT_THAT(pairs, SizeIs(1));
  EXPECT_EQ(pairs[0].color.file, "color/a.png");
}

TEST_F(ImageLists, OfTwoNamesTakeTheStampsOfTheOtherLists) {
  folder.write("rgb.txt", "1.5 rgb/a.png\n");
  folder.write("depth.txt", "1.25 depth/b.png\n");
  folder.write("associations.txt", "rgb/a.png depth/b.png\n");
  const auto pairs = listPairs();
  ASSERT_THAT(pairs, SizeIs(1));
  EXPECT_EQ(pairs[0].color.stamp_s, 1.5);
  EXPECT_EQ(pairs[0].depth.stamp_s, 1.25);
}

TEST_F(ImageLists, ThatAreNotThereAreTheNamesOfTheFiles) {
  std::filesystem::create_directories(folder.path() / "rgb");
  std::filesystem::create_directories(folder.path() / "depth");
  for (const char* file : {"rgb/1.5.png", "rgb/2.5.png", "depth/1.501.png", "depth/2.501.png"}) folder.write(file, "");
  const auto pairs = listPairs();
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_EQ(pairs[0].color.stamp_s, 1.5);
  EXPECT_EQ(pairs[1].depth.file, "depth/2.501.png");
  EXPECT_THAT(notes, ElementsAre(HasSubstr("has no list")));
}

TEST_F(ImageLists, AreReadByTheirClock) {
  const std::vector<std::pair<std::string, std::string>> clocks = {
      {"1700000003333333333", "nanoseconds"}, {"1700000003333333", "microseconds"}, {"1700000003333", "milliseconds"}};
  for (const auto& [stamp, unit] : clocks) {
    notes.clear();
    folder.write("rgb.txt", "#timestamp [ns],filename\n" + stamp + ",rgb/a.png\n");
    folder.write("depth.txt", stamp + ",depth/a.png\n");
    const auto pairs = listPairs();
    ASSERT_THAT(pairs, SizeIs(1)) << unit;
    EXPECT_NEAR(pairs[0].color.stamp_s, 1700000003.333333, 4e-4) << unit;
    EXPECT_NEAR(std::stod(pairs[0].color.stampText), 1700000003.333333, 4e-4) << unit;
    EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("rgb.txt"), HasSubstr(unit))));
  }
}

TEST_F(ImageLists, ThatNumberImagesCountAtTheRate) {
  folder.write("associations.txt", "0 depth/0.png 0 rgb/0.png\n1 depth/1.png 1 rgb/1.png\n2 depth/2.png 2 rgb/2.png\n");
  const auto pairs = listPairs(20.0);
  ASSERT_THAT(pairs, SizeIs(3));
  EXPECT_EQ(pairs[0].color.file, "rgb/0.png");
  EXPECT_DOUBLE_EQ(pairs[1].color.stamp_s, 0.05);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("20 a second")));
}

TEST_F(ImageLists, ThatCouldMeanTwoThingsAreAskedFor) {
  folder.write("rgb.txt", "0 a.png\n33 b.png\n66 c.png\n99 d.png\n");
  folder.write("depth.txt", "0 a.png\n33 b.png\n66 c.png\n99 d.png\n");
  expectError("rgb.txt:1", "milliseconds as well as images");
}

TEST_F(ImageLists, OfUtf16AreNamed) {
  folder.write("rgb.txt", std::string("\xFF\xFE"
                                      "1\0 \0",
                                      6));
  expectError("rgb.txt", "UTF-16");
}

TEST_F(ImageLists, ListsOfDifferentClocksAreAnError) {
  folder.write("rgb.txt", "1.0 rgb/a.png\n");
  folder.write("depth.txt", "1000001.0 depth/x.png\n");
  expectError(folder.path().string(), "same clock");
}

}  // namespace
}  // namespace wardslam::sources
