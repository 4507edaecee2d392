#include "blob_codecs.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/hand_made_map.h"

namespace wardslam::storage {
namespace {

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && (a.empty() || cv::norm(a, b, cv::NORM_INF) == 0);
}

TEST(BlobCodecs, FeaturesComeBackToTheBit) {
  const auto features = test::makeView(1, test::makeWard())->features;
  const auto read = decodeFeatures(encodeFeatures(features));
  ASSERT_EQ(read.size(), features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto& a = features.keypoints[i];
    const auto& b = read.keypoints[i];
    EXPECT_EQ(a.raw_px, b.raw_px);
    EXPECT_EQ(a.undistorted_px, b.undistorted_px);
    EXPECT_EQ(a.depth_m, b.depth_m);
    EXPECT_EQ(a.depthSpread_m, b.depthSpread_m);
    EXPECT_EQ(a.angle_rad, b.angle_rad);
    EXPECT_EQ(a.response, b.response);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(b.motion, core::Motion::Static);
  }
  EXPECT_TRUE(equal(read.descriptors, features.descriptors));
}

/// One key point of the first layout: eight numbers, a descriptor.
TEST(BlobCodecs, FeaturesOfTheFirstLayoutAreRead) {
  core::ByteWriter out;
  out.put(std::uint32_t{1});
  for (const float value : {10.0F, 20.0F, 11.0F, 21.0F, 2.5F, 0.5F, 7.0F, 1.2F}) out.put(value);
  const std::vector<std::uint8_t> descriptor(32, 9);
  out.putBytes(descriptor.data(), descriptor.size());
  const auto read = decodeFeatures(core::pack(core::BlobKind::Features, 1, out.bytes()));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read.keypoints[0].depth_m, 2.5F);
  EXPECT_EQ(read.keypoints[0].scale, 1.2F);
  EXPECT_EQ(read.keypoints[0].depthSpread_m, 0.0F) << "nobody knows";
  EXPECT_EQ(read.descriptors.at<std::uint8_t>(0, 31), 9);
}

TEST(BlobCodecs, TilesComeBackToTheBit) {
  const auto tile = test::makeWard().cloud.at(2);
  const auto read = decodeTile(encodeTile(tile));
  ASSERT_EQ(read.points.size(), tile.points.size());
  for (std::size_t i = 0; i < tile.points.size(); ++i) {
    EXPECT_EQ(read.points[i].p_cam_m, tile.points[i].p_cam_m);
    EXPECT_EQ(read.points[i].color_rgb, tile.points[i].color_rgb);
    EXPECT_EQ(read.points[i].classId, tile.points[i].classId);
    EXPECT_EQ(read.points[i].object, tile.points[i].object);
    EXPECT_EQ(read.points[i].sightings, tile.points[i].sightings);
  }
}

TEST(BlobCodecs, CellsComeBack) {
  const auto cells = test::makeFloorPlan().cells;
  EXPECT_TRUE(equal(decodeCells(encodeCells(cells)), cells));
  EXPECT_TRUE(equal(decodeCells(encodeCells(cells.colRange(3, 90))), cells.colRange(3, 90))) << "not continuous";
}

TEST(BlobCodecs, NothingComesBackAsNothing) {
  EXPECT_EQ(decodeFeatures(encodeFeatures({})).size(), 0U);
  EXPECT_TRUE(decodeTile(encodeTile({})).points.empty());
  EXPECT_TRUE(decodeCells(encodeCells({})).empty());
}

TEST(BlobCodecs, RefuseContentOfAnotherLength) {
  core::ByteWriter out;
  out.put(std::uint32_t{1000});
  out.put(1.0F);
  for (const std::uint8_t version : {std::uint8_t{1}, std::uint8_t{2}}) {
    EXPECT_THROW((void)decodeFeatures(core::pack(core::BlobKind::Features, version, out.bytes())), core::BlobError);
  }
  EXPECT_THROW((void)decodeTile(core::pack(core::BlobKind::CloudTile, 1, out.bytes())), core::BlobError);
  EXPECT_THROW((void)decodeCells(core::pack(core::BlobKind::FloorCells, 1, out.bytes())), core::BlobError);
  EXPECT_THROW((void)decodeCells(core::pack(core::BlobKind::FloorCells, 1, {})), core::BlobError);
}

TEST(BlobCodecs, RefuseWhatNoCameraSees) {
  const auto sound = test::makeView(1, test::makeWard())->features;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refuses = [&](float core::Keypoint::*field, float value) {
    auto features = sound;
    features.keypoints[3].*field = value;
    EXPECT_THROW((void)decodeFeatures(encodeFeatures(features)), core::BlobError) << value;
  };
  refuses(&core::Keypoint::depth_m, -1.0F);
  refuses(&core::Keypoint::depth_m, nan);
  refuses(&core::Keypoint::depthSpread_m, -1.0F);
  refuses(&core::Keypoint::depthSpread_m, nan);
  refuses(&core::Keypoint::scale, 0.0F);
  refuses(&core::Keypoint::angle_rad, nan);
  auto features = sound;
  features.keypoints[3].undistorted_px.x = nan;
  EXPECT_THROW((void)decodeFeatures(encodeFeatures(features)), core::BlobError);
  EXPECT_THROW((void)decodeFan(encodeFan({{1.0F, nan, 1.0F}})), core::BlobError);
  EXPECT_THROW((void)decodeFan(encodeFan({{1.0F, 1e30F, 1.0F}})), core::BlobError);
  mapping::SemanticCloudTile tile;
  tile.points.resize(1);
  tile.points[0].p_cam_m = {0.0F, 0.0F, nan};
  EXPECT_THROW((void)decodeTile(encodeTile(tile)), core::BlobError);
}

TEST(BlobCodecs, GiveADepthViewBack) {
  const odometry::DepthView view{5, 3, 2, {1000, 0, 65000, 1, 2, 3}, {1000, 0, 65000, 900, 2, 4}};
  const auto back = decodeDepthView(encodeDepthView(view));
  EXPECT_EQ(back.cell_px, 5);
  EXPECT_EQ(back.columns, 3);
  EXPECT_EQ(back.rows, 2);
  EXPECT_EQ(back.nearest_mm, view.nearest_mm);
  EXPECT_EQ(back.farthest_mm, view.farthest_mm);
  EXPECT_EQ(decodeDepthView(encodeDepthView({})).columns, 0);
}

TEST(BlobCodecs, RefuseADepthViewOfOtherSizeThanItSays) {
  const auto viewOf = [](std::uint16_t columns, std::vector<std::uint16_t> values) {
    core::ByteWriter out;
    for (const std::uint16_t value : {std::uint16_t{4}, columns, std::uint16_t{1}}) out.put(value);
    for (const std::uint16_t value : values) out.put(value);
    return core::pack(core::BlobKind::DepthView, 1, out.bytes());
  };
  EXPECT_EQ(decodeDepthView(viewOf(1, {1000, 20})).farthest_mm.at(0), 1020);
  EXPECT_THROW((void)decodeDepthView(viewOf(2, {1000, 20})), core::BlobError);
  EXPECT_THROW((void)decodeDepthView(viewOf(1, {1000, 20, 7})), core::BlobError);
  EXPECT_THROW((void)decodeDepthView(viewOf(1, {65000, 1000})), core::BlobError) << "farther than can be told";
}

TEST(BlobCodecs, RefuseSizesThatOverflow) {
  core::ByteWriter out;
  out.put(std::uint32_t{0x80000000});
  out.put(std::uint32_t{0x80000000});
  EXPECT_THROW((void)decodeCells(core::pack(core::BlobKind::FloorCells, 1, out.bytes())), core::BlobError);
}

}  // namespace
}  // namespace wardslam::storage
