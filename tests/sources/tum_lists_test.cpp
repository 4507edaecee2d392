#include "wardslam/sources/tum_lists.h"

#include <gmock/gmock.h>

#include "sources/tum_folder_writer.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
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
  test::TemporaryFolder folder;
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

TEST_F(ImageLists, StampsMustIncrease) {
  folder.write("rgb.txt", "1.0 rgb/a.png\n1.0 rgb/b.png\n");
  expectError("rgb.txt:2:", "not later");
}

TEST_F(ImageLists, ListsOfDifferentClocksAreAnError) {
  folder.write("rgb.txt", "1.0 rgb/a.png\n");
  folder.write("depth.txt", "1000001.0 depth/x.png\n");
  expectError(folder.path().string(), "same clock");
}

}  // namespace
}  // namespace wardslam::sources
