#include "wardslam/core/first_bytes.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace wardslam::core {
namespace {

TEST(FirstBytes, AreThoseThereAre) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(firstBytes(folder.write("a", "SQLite format 3"), 6), "SQLite");
  EXPECT_EQ(firstBytes(folder.write("b", "BZh"), 16), "BZh");
  EXPECT_EQ(firstBytes(folder.write("c", ""), 16), "");
  EXPECT_EQ(firstBytes(folder.path() / "none", 16), "");
  EXPECT_EQ(firstBytes(folder.path(), 16), "");
}

}  // namespace
}  // namespace wardslam::core
