#include "digest.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace wardslam::reproduction {
namespace {

TEST(Digest, OfAFileIsItsSha256) {
  const test::TemporaryFolder folder;
  // FIPS 180-2, B.1
  EXPECT_EQ(digestOfFile(folder.write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_NE(digestOfFile(folder.write("long", std::string(3U << 20U, 'a'))),
            digestOfFile(folder.write("other", std::string((3U << 20U) - 1, 'a') + "b")))
      << "read to the end";
  EXPECT_EQ(digestOfFile(folder.path() / "none"), "absent");
  EXPECT_EQ(digestOfFile(folder.path()), "absent");
}

TEST(Digest, OfAFolderIsItsExtent) {
  const test::TemporaryFolder folder;
  folder.write("images/a.png", "12345");
  folder.write("images/b.png", "123");
  folder.write("images/deeper/c.png", "1");
  EXPECT_EQ(extentOfFolder(folder.path() / "images"), "2 files, 8 bytes");
  EXPECT_EQ(extentOfFolder(folder.path() / "none"), "absent");
}

}  // namespace
}  // namespace wardslam::reproduction
