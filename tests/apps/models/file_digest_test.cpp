#include "models/file_digest.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

// FIPS 180-2, appendix B.
TEST(FileDigest, GivesThePublishedChecksums) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(fileDigest(folder.write("abc", "abc"), "sha256"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(fileDigest(folder.write("empty", ""), "sha256"),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(fileDigest(folder.write("million", std::string(1000000, 'a')), "sha256"),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(FileDigest, KnowsItsLength) {
  EXPECT_EQ(digestLength("sha256"), 64U);
  EXPECT_EQ(digestLength("sha384"), 96U);
  EXPECT_EQ(digestLength("sha257"), 0U);
}

TEST(FileDigest, RefusesWhatItCannotRead) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)fileDigest(folder.path() / "none", "sha256"), core::InputError);
  EXPECT_THROW((void)fileDigest(folder.path(), "sha256"), core::InputError);
  EXPECT_THROW((void)fileDigest(folder.write("abc", "abc"), "sha257"), std::invalid_argument);
}

}  // namespace
}  // namespace wardslam::apps
