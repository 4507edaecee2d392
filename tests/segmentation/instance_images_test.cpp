#include "wardslam/segmentation/instance_images.h"

#include <gtest/gtest.h>

namespace wardslam::segmentation {
namespace {

cv::Mat image8(const std::vector<std::vector<int>>& rows, int type = CV_8UC1) {
  cv::Mat image(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()), CV_32S);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x)
      image.at<int>(y, x) = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  }
  cv::Mat converted;
  image.convertTo(converted, type);
  return converted;
}

cv::Mat image16(const std::vector<std::vector<int>>& rows) { return image8(rows, CV_16UC1); }

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

void expectInstance(const core::Instance& instance, std::uint16_t id, core::ClassId classId, const cv::Rect& box_px) {
  EXPECT_EQ(instance.id, id);
  EXPECT_EQ(instance.classId, classId);
  EXPECT_EQ(instance.box_px, box_px);
  EXPECT_EQ(instance.confidence, 1.0F);
}

TEST(ListInstances, GivesClassAndBoxInOrderOfId) {
  const cv::Mat classes = image8({{1, 1, 0, 57, 57},  //
                                  {1, 0, 0, 57, 0},
                                  {0, 0, 1, 1, 0}});
  cv::Mat ids = image16({{300, 300, 0, 2, 2},  //
                         {300, 0, 0, 2, 0},
                         {0, 0, 2000, 2000, 0}});
  const auto instances = listInstances(classes, ids);
  ASSERT_EQ(instances.size(), 3U);
  expectInstance(instances[0], 2, 57, {3, 0, 2, 2});
  expectInstance(instances[1], 300, 1, {0, 0, 2, 2});
  expectInstance(instances[2], 2000, 1, {2, 2, 2, 1});
}

TEST(ListInstances, SpansThePartsOfAnInstanceThatIsCovered) {
  const cv::Mat classes = image8({{1, 60, 1}});
  cv::Mat ids = image16({{5, 6, 5}});
  const auto instances = listInstances(classes, ids);
  ASSERT_EQ(instances.size(), 2U);
  expectInstance(instances[0], 5, 1, {0, 0, 3, 1});
  expectInstance(instances[1], 6, 60, {1, 0, 1, 1});
}

TEST(ListInstances, TakesTheClassOfMostPixels) {
  const cv::Mat classes = image8({{1, 57, 57, 102, 57}});
  cv::Mat ids = image16({{5, 5, 5, 5, 5}});
  const auto instances = listInstances(classes, ids);
  ASSERT_EQ(instances.size(), 1U);
  expectInstance(instances[0], 5, 57, {0, 0, 5, 1});
}

TEST(ListInstances, ClearsIdsWhereThereIsNoClass) {
  const cv::Mat classes = image8({{0, 0, 1}, {0, 1, 1}});
  cv::Mat ids = image16({{4, 5, 5}, {4, 0, 5}});
  const auto instances = listInstances(classes, ids);
  ASSERT_EQ(instances.size(), 1U);
  expectInstance(instances[0], 5, 1, {2, 0, 1, 2});
  EXPECT_TRUE(same(ids, image16({{0, 0, 5}, {0, 0, 5}})));
}

TEST(LabelRegions, NumbersTheRegionsOfEachClass) {
  const cv::Mat classes = image8({{57, 57, 0, 1, 0},  //
                                  {57, 1, 0, 0, 1},
                                  {0, 1, 0, 57, 57}});
  // The second person's pixels touch at a corner only.
  EXPECT_TRUE(same(labelRegions(classes, 1), image16({{3, 3, 0, 2, 0},  //
                                                      {3, 1, 0, 0, 2},
                                                      {0, 1, 0, 4, 4}})) ||
              same(labelRegions(classes, 1), image16({{3, 3, 0, 1, 0},  //
                                                      {3, 2, 0, 0, 1},
                                                      {0, 2, 0, 4, 4}})));
}

TEST(LabelRegions, LeavesSmallRegionsOut) {
  const cv::Mat classes = image8({{1, 1, 1, 0, 60},  //
                                  {0, 0, 0, 0, 60}});
  EXPECT_TRUE(same(labelRegions(classes, 3), image16({{1, 1, 1, 0, 0}, {0, 0, 0, 0, 0}})));
  EXPECT_TRUE(same(labelRegions(classes, 2), image16({{1, 1, 1, 0, 2}, {0, 0, 0, 0, 2}})));
}

TEST(LabelRegions, FindsNothingInAnEmptyImage) {
  EXPECT_EQ(cv::countNonZero(labelRegions(cv::Mat(4, 4, CV_8UC1, cv::Scalar(0)), 1)), 0);
}

}  // namespace
}  // namespace wardslam::segmentation
