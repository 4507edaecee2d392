#include "detections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr core::ClassId kPerson = 1;
constexpr core::ClassId kChair = 57;
constexpr float kCell_m = 0.025F;

/// A view's instances and their samples, seen along z from the origin.
class DetectionsTest : public testing::Test {
 protected:
  void addInstance(std::uint16_t id, core::ClassId classId, float confidence = 1.0F) {
    core::Instance instance;
    instance.id = id;
    instance.classId = classId;
    instance.confidence = confidence;
    segmentation_.instances.push_back(instance);
  }

  /// A patch of `side` × `side` samples, 5 cm apart, from (x_m, 0) on.
  void addPatch(std::uint16_t instance, float x_m, float depth_m, int side) {
    for (int i = 0; i < side * side; ++i) {
      Sample sample;
      sample.p_map_m = {x_m + 0.05F * static_cast<float>(i % side), 0.05F * static_cast<float>(i / side), depth_m};
      sample.depth_m = depth_m;
      sample.pixels = 1;
      sample.instance = instance;
      samples_.push_back(sample);
    }
  }

  [[nodiscard]] std::vector<Detection> detections() const {
    knowledge::ClassSet moving;
    moving.set(kPerson);
    return detect(segmentation_, samples_, moving, ObjectOptions(), kCell_m);
  }

  core::Segmentation segmentation_;
  std::vector<Sample> samples_;
};

TEST_F(DetectionsTest, SayWhatAnInstanceIsAndWhere) {
  addInstance(4, kChair, 0.7F);
  addPatch(4, 1.0F, 2.0F, 5);
  const auto found = detections();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].classId, kChair);
  EXPECT_FLOAT_EQ(found[0].confidence, 0.7F);
  EXPECT_THAT(found[0].samples, SizeIs(25));
  EXPECT_THAT(found[0].doubtful, IsEmpty());
  EXPECT_TRUE(found[0].centroid_m.isApprox(Eigen::Vector3f(1.1F, 0.1F, 2.0F), 1e-4F));
}

TEST_F(DetectionsTest, DoubtTheWallBehindThatAMaskBleedsOnto) {
  addInstance(1, kChair);
  addPatch(1, 0.0F, 2.0F, 5);
  addPatch(1, 0.3F, 3.5F, 3);
  const auto found = detections();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].samples, SizeIs(25));
  EXPECT_THAT(found[0].doubtful, SizeIs(9));
}

TEST_F(DetectionsTest, KeepPartsAtOneDepthTogether) {
  addInstance(1, kChair);
  addPatch(1, 0.0F, 2.0F, 5);
  addPatch(1, 0.8F, 2.0F, 3);  // something stands before its middle
  const auto found = detections();
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].samples, SizeIs(34));
}

TEST_F(DetectionsTest, LeaveOutPeopleTheUnnamedAndTheTooSmall) {
  addInstance(1, kPerson);
  addPatch(1, 0.0F, 2.0F, 5);
  addInstance(2, 0);
  addPatch(2, 2.0F, 2.0F, 5);
  addInstance(3, kChair);
  addPatch(3, 4.0F, 2.0F, 2);  // 4 samples; 8 are the least
  EXPECT_THAT(detections(), IsEmpty());
}

}  // namespace
}  // namespace wardslam::mapping
