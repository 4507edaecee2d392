#include "wardslam/core/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "out.txt";
  fs::path partial_ = folder_.path() / "out.txt.partial";
};

TEST_F(AtomicFileTest, AppearsOnlyOnCommit) {
  AtomicFile out(file_);
  out.stream() << "first\n";
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_TRUE(fs::exists(partial_));
  out.commit();
  EXPECT_EQ(test::readText(file_), "first\n");
  EXPECT_FALSE(fs::exists(partial_));
}

TEST_F(AtomicFileTest, OldContentStaysUntilCommit) {
  writeFileAtomically(file_, "old");
  AtomicFile out(file_);
  out.stream() << "new";
  EXPECT_EQ(test::readText(file_), "old");
  out.commit();
  EXPECT_EQ(test::readText(file_), "new");
}

TEST_F(AtomicFileTest, OtherWritersGetThePartialName) {
  replaceAtomically(file_, [&](const fs::path& partial) {
    EXPECT_EQ(partial, partial_);
    EXPECT_FALSE(fs::exists(file_));
    folder_.write(partial.filename().string(), "all");
  });
  EXPECT_EQ(test::readText(file_), "all");
  EXPECT_FALSE(fs::exists(partial_));
  EXPECT_THROW(replaceAtomically(file_, [](const fs::path&) {}), InputError) << "nothing was written";
}

TEST_F(AtomicFileTest, WithoutCommitThePartialFileKeepsWhatWasWritten) {
  { AtomicFile(file_).stream() << "half"; }
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_EQ(test::readText(partial_), "half");
}

TEST_F(AtomicFileTest, MissingFolderIsNamed) {
  EXPECT_THAT([&] { AtomicFile out(folder_.path() / "none" / "out.txt"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("none/out.txt.partial: cannot be created")));
}

TEST_F(AtomicFileTest, FullDiskIsToldAndTheOldFileStays) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full to stand for a full disk";
  writeFileAtomically(file_, "old");
  fs::create_symlink("/dev/full", partial_);
  EXPECT_THAT([&] { writeFileAtomically(file_, "new"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("is the disk full")));
  EXPECT_EQ(test::readText(file_), "old");
}

TEST_F(AtomicFileTest, TargetThatCannotBeReplacedIsTold) {
  fs::create_directories(file_ / "occupied");
  EXPECT_THAT([&] { writeFileAtomically(file_, "text"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("out.txt: cannot be replaced")));
}

}  // namespace
}  // namespace wardslam::core
