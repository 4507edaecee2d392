#include "wardslam/core/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <vector>

#include "support/full_disk.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace {

/// Of the files and folders the disk was told to take over.
std::vector<ino_t>& syncedInodes() {
  static std::vector<ino_t> all;
  return all;
}

}  // namespace

/// In place of the system's, which knows no way of being asked.
extern "C" int fsync(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) == 0) syncedInodes().push_back(status.st_ino);
  return ::fdatasync(descriptor);
}

namespace wardslam::core {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "out.txt";
  fs::path partial_ = folder_.path() / "out.txt.partial";

  static ino_t inodeOf(const fs::path& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
  }
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

TEST_F(AtomicFileTest, WhatAFullDiskDidNotTakeIsWrittenLater) {
  AtomicFile out(file_);
  const std::string before(500, 'a');
  const std::string meanwhile(3000, 'b');
  out.stream() << before << std::flush;
  EXPECT_FALSE(out.isBehind());
  {
    const test::FullDisk full;
    out.stream() << meanwhile << std::flush << "c" << std::flush;
    EXPECT_TRUE(out.isBehind());
    EXPECT_THROW(out.commit(), InputError);
  }
  EXPECT_FALSE(fs::exists(file_));
  out.stream() << "d" << std::flush;
  EXPECT_FALSE(out.isBehind());
  out.commit();
  EXPECT_EQ(test::readText(file_), before + meanwhile + "cd");
}

TEST_F(AtomicFileTest, AFileThatWasCommittedSurvivesAPowerCut) {
  syncedInodes().clear();
  writeFileAtomically(file_, "all");
  EXPECT_THAT(syncedInodes(), testing::ElementsAre(inodeOf(file_), inodeOf(folder_.path()))) << "in this order";
}

TEST_F(AtomicFileTest, DevicesAndPipesAreNotReplaced) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  const auto isTold = testing::ThrowsMessage<InputError>(testing::HasSubstr("out.txt: is a device or a pipe"));
  EXPECT_THAT([&] { writeFileAtomically(file_, "text"); }, isTold);
  EXPECT_THAT([&] { replaceAtomically(file_, [](const fs::path& partial) { std::ofstream(partial) << "text"; }); },
              isTold);
  EXPECT_TRUE(fs::is_fifo(file_));
  EXPECT_FALSE(fs::exists(partial_));
}

TEST_F(AtomicFileTest, TargetThatCannotBeReplacedIsTold) {
  fs::create_directories(file_ / "occupied");
  EXPECT_THAT([&] { writeFileAtomically(file_, "text"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("out.txt: cannot be replaced")));
}

}  // namespace
}  // namespace wardslam::core
