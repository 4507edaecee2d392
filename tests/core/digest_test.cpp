#include "wardslam/core/digest.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

// FIPS 180-2, appendix B.
TEST(Digest, GivesThePublishedChecksums) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(digestOfFile(folder.write("abc", "abc"), "sha256"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digestOfFile(folder.write("empty", ""), "sha256"),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digestOfFile(folder.write("million", std::string(1000000, 'a')), "sha256"),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, TakesBytesAsTheyCome) {
  EXPECT_EQ(digestOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  Digest digest;
  digest.add("a");
  digest.add("");
  digest.add("bc");
  EXPECT_EQ(digest.result(), digestOf("abc"));
}

TEST(Digest, KnowsItsLength) {
  EXPECT_EQ(digestLength("sha256"), 64U);
  EXPECT_EQ(digestLength("sha384"), 96U);
  EXPECT_EQ(digestLength("sha257"), 0U);
}

TEST(Digest, RefusesWhatItCannotRead) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)digestOfFile(folder.path() / "none", "sha256"), InputError);
  EXPECT_THROW((void)digestOfFile(folder.path(), "sha256"), InputError);
  EXPECT_THROW((void)digestOfFile(folder.write("abc", "abc"), "sha257"), std::invalid_argument);
}

}  // namespace
}  // namespace wardslam::core
