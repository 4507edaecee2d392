#include "wardslam/pipeline/ini_options.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>

#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::pipeline {
namespace {

using testing::AllOf;
using testing::HasSubstr;

SlamOptions read(const std::string& ini) {
  return readSlamOptions(mrpt::config::CConfigFileMemory("[WardSLAM]\n" + ini), "WardSLAM");
}

std::string complaintAbout(const std::string& ini) {
  return test::complaintOf([&] { return read(ini); });
}

TEST(IniOptions, AreThoseOfTheYamlByTheirPaths) {
  const auto options =
      read("features.key_points = 1234\ndeterministic = true\nodometry.matcher.wide_radius_px = 17.5 // why\n");
  EXPECT_EQ(options.features.key_points, 1234);
  EXPECT_TRUE(options.deterministic);
  EXPECT_EQ(options.odometry.matcher.wide_radius_px, 17.5);
  EXPECT_EQ(options.mapping.cloud.voxel_m, SlamOptions().mapping.cloud.voxel_m);
}

TEST(IniOptions, OverruleTheFileTheyName) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.yaml", "features: {key_points: 500, levels: 6}\nfilters: []\n");
  const auto options = read("config = " + file.string() + "\nfeatures.key_points = 700\n");
  EXPECT_EQ(options.features.key_points, 700);
  EXPECT_EQ(options.features.levels, 6);
  EXPECT_EQ(options.filters.yaml().size(), 0U);
}

TEST(IniOptions, FindTheFileBesideTheirs) {
  const test::TemporaryFolder folder;
  (void)folder.write("parts/a.yaml", "features: {key_points: 500}\n");
  const auto ini = folder.write("app.ini", "[SLAM]\nconfig = parts/a.yaml\n");
  EXPECT_EQ(readSlamOptions(mrpt::config::CConfigFile(ini.string()), "SLAM").features.key_points, 500);
}

TEST(IniOptions, AnEmptySectionMeansTheDefaults) {
  EXPECT_EQ(read("").features.key_points, SlamOptions().features.key_points);
}

TEST(IniOptions, SayWhatIsWrong) {
  EXPECT_THAT(complaintAbout("features.keypoints = 3\n"), AllOf(HasSubstr("[WardSLAM]"), HasSubstr("key_points")));
  EXPECT_THAT(complaintAbout("features.key_points = many\n"), HasSubstr("features.key_points"));
  EXPECT_THAT(complaintAbout("config = /nowhere/a.yaml\n"), HasSubstr("/nowhere/a.yaml"));
  EXPECT_THAT(complaintAbout("features = 3\nfeatures.key_points = 300\n"), HasSubstr("features"));
  EXPECT_THROW((void)readSlamOptions(mrpt::config::CConfigFileMemory("[other]\n"), "WardSLAM"), core::InputError);
}

}  // namespace
}  // namespace wardslam::pipeline
