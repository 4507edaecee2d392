#include "recording/tum_notes.h"

#include <gmock/gmock.h>

#include "recording/rawlog_writer.h"
#include "sources/scan_maker.h"
#include "sources/tum_folder_writer.h"
#include "support/temporary_folder.h"

namespace wardslam::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(TumNotes, KeepStampsToTheLetterAndFilesToTheByte) {
  const test::TumFolder sequence(1);
  sequence.write("associations.txt", "# by hand\n100.1 rgb/0.png 0100.25000 depth/0.png\n");
  sequence.write("groundtruth.txt", "# truth\r\n100.1 0 0 0 0 0 0 1\n\n");
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "out.rawlog";
  RawlogWriter writer(file);
  writeTumNotes(notesOfTumFolder(sequence.path()), writer);
  writer.write(*test::makeScan());
  writer.commit();

  const TumNotes notes = readTumNotes(file);
  ASSERT_EQ(notes.pairs.size(), 1U);
  EXPECT_EQ(notes.pairs[0].colorStamp, "100.1");
  EXPECT_EQ(notes.pairs[0].colorFile, "rgb/0.png");
  EXPECT_EQ(notes.pairs[0].depthStamp, "0100.25000");
  EXPECT_EQ(notes.pairs[0].depthFile, "depth/0.png");
  EXPECT_THAT(notes.files, ElementsAre(Pair("groundtruth.txt", "# truth\r\n100.1 0 0 0 0 0 0 1\n\n")));
}

TEST(TumNotes, AreNoneInOtherRawlogs) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "out.rawlog";
  RawlogWriter writer(file);
  writer.write(*test::makeScan());
  writer.commit();
  const TumNotes notes = readTumNotes(file);
  EXPECT_THAT(notes.pairs, IsEmpty());
  EXPECT_THAT(notes.files, IsEmpty());
}

}  // namespace
}  // namespace wardslam::recording
