#include "wardslam/core/nearest_name.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

TEST(NearestName, IsTheOneWithTheFewestEdits) {
  const std::vector<std::string> names{"key_points", "levels", "scale_factor"};
  EXPECT_EQ(nearestName("keypoints", names), "key_points");       // one insertion
  EXPECT_EQ(nearestName("level", names), "levels");               // one insertion
  EXPECT_EQ(nearestName("scale_fcator", names), "scale_factor");  // two replacements
  EXPECT_EQ(nearestName("levels", names), "levels");
}

TEST(NearestName, CountsInsertDeleteAndReplaceAlike) {
  // kitten -> sitting takes 3 edits (the textbook example), kitten -> mitts 3 as well, kitten -> kit 3; bitter 2.
  EXPECT_EQ(nearestName("kitten", {"sitting", "kit", "bitter"}), "bitter");
  EXPECT_EQ(nearestName("abcd", {"wxyz", "a"}), "a");  // 4 replacements against 3 deletions
}

TEST(NearestName, FirstOfEquallyNearNames) { EXPECT_EQ(nearestName("b", {"a", "c"}), "a"); }

TEST(NearestName, NothingToChooseFrom) {
  EXPECT_EQ(nearestName("b", {}), "");
  EXPECT_EQ(nearestName("", {"abc", "d"}), "d");
}

}  // namespace
}  // namespace wardslam::core
