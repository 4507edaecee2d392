#include "runs.h"

#include <gmock/gmock.h>

#include "merging/meeting_maps.h"
#include "support/complaint.h"

namespace wardslam::merging {
namespace {

using test::MeetingMaps;
using testing::HasSubstr;
using testing::IsEmpty;

void goOn(const Progress& /*progress*/) {}

TEST(RunsTest, TheOldestComesFirstAndNoNumberIsGivenTwice) {
  const MeetingMaps maps;
  const auto runs = readRuns({maps.b(), maps.a()}, goOn);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].name, "a.wardmap");
  EXPECT_EQ(runs[1].name, "b.wardmap");
  EXPECT_EQ(runs[0].map.graph.keyframes.back()->id, 16U);
  EXPECT_EQ(runs[1].map.graph.keyframes.front()->id, 17U);
}

TEST(RunsTest, FilesOfOneNameGoByTheirFolders) {
  const MeetingMaps maps;
  for (const char* folder : {"monday", "tuesday"}) std::filesystem::create_directory(maps.file(folder));
  std::filesystem::copy_file(maps.a(), maps.file("monday/map.wardmap"));
  std::filesystem::copy_file(maps.b(), maps.file("tuesday/map.wardmap"));
  const auto runs = readRuns({maps.file("tuesday/map.wardmap"), maps.file("monday/map.wardmap")}, goOn);
  EXPECT_EQ(runs[0].name, "monday/map.wardmap");
  EXPECT_EQ(runs[1].name, "tuesday/map.wardmap");
}

/// Two maps, in each a thing of one class.
class NamesTest : public testing::Test {
 protected:
  NamesTest() : runs_(readRuns({maps_.a(), maps_.b()}, goOn)) {
    for (merging::Run& run : runs_) run.map.semantic.objects[1].classId = 57;
  }
  std::string complaint() {
    return test::complaintOf([&] { requireThatTheyFit(runs_); });
  }
  MeetingMaps maps_;
  std::vector<merging::Run> runs_;
};

TEST_F(NamesTest, OfClassesMustBeTheSame) {
  EXPECT_THAT(complaint(), IsEmpty());
  runs_[1].header.labels.rename(57, "sofa");
  EXPECT_THAT(complaint(), HasSubstr("class 57 is 'chair' in "));
}

TEST_F(NamesTest, MustHaveOneNumber) {
  runs_[1].header.labels.rename(57, "");
  runs_[1].header.labels.rename(200, "chair");
  EXPECT_THAT(complaint(), HasSubstr("class 57 is 'chair' in "));
}

TEST_F(NamesTest, OfClassesOfWhichNothingIsThereDoNotMatter) {
  runs_[1].header.labels.rename(60, "stretcher");
  EXPECT_THAT(complaint(), IsEmpty());
}

}  // namespace
}  // namespace wardslam::merging
