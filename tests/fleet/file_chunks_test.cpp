#include "file_chunks.h"

#include <random>

#include "fleet/fleet_test.h"
#include "wardslam/fleet/stored_maps.h"

namespace wardslam::fleet {
namespace {

constexpr std::uint64_t kChunk_bytes = 1U << 20U;

/// A map whose file has three pieces or more, for its points are random.
class FileChunksTest : public FleetTest {
 protected:
  void SetUp() override {
    FleetTest::SetUp();
    if (IsSkipped()) return;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> anywhere_m(-5.0F, 5.0F);
    auto& points = ward_.cloud[1].points;
    points.resize(400000);
    for (auto& point : points) point.p_cam_m = {anywhere_m(random), anywhere_m(random), anywhere_m(random)};
    writeWard();
    ASSERT_GT(size_bytes(), 2 * kChunk_bytes);
  }

  [[nodiscard]] std::uint64_t size_bytes() const { return std::filesystem::file_size(file_); }
  [[nodiscard]] std::string unused() const {
    return sql("SELECT count(*) FROM chunks WHERE digest NOT IN (SELECT digest FROM file_chunks)");
  }

  /// Interrupted when one piece is there.
  void pushOnePiece() const {
    PushOptions options;
    options.isInterrupted = [] { return true; };
    EXPECT_THAT(test::complaintOf([&] { return push(url_, kOne, file_, options).objects; }),
                testing::HasSubstr("the next push goes on there"));
  }

  const MapIdentity kOne{"robot 1", "ward", "north", "1"};
  const MapIdentity kOther{"robot 2", "ward", "north", "1"};
};

TEST_F(FileChunksTest, WhatBrokeOffGoesOn) {
  pushOnePiece();
  EXPECT_EQ(count("chunks"), 1);
  EXPECT_EQ(count("maps"), 0);
  EXPECT_EQ(push(url_, kOne, file_).file_bytes, size_bytes() - kChunk_bytes);
}

TEST_F(FileChunksTest, WhatTwoFilesHaveInCommonIsSentOnce) {
  (void)push(url_, kOne, file_);
  EXPECT_EQ(push(url_, kOther, file_).file_bytes, 0U);
  EXPECT_EQ(count("file_chunks"), 2 * count("chunks"));
  const auto pulled = folder_.path() / "pulled.wardmap";
  (void)pullNewestMap(url_, {"", "", "robot 2", ""}, pulled);
  EXPECT_TRUE(test::readText(pulled) == test::readText(file_));
}

TEST_F(FileChunksTest, WhatNoFileHasAnyMoreIsDropped) {
  (void)push(url_, kOne, file_);
  (void)push(url_, kOther, file_);
  drive(1.0);
  (void)pushWard(kOne);
  EXPECT_EQ(unused(), "0");
  EXPECT_EQ(push(url_, kOther, file_).file_bytes, 0U);
  EXPECT_EQ(count("file_chunks"), 2 * count("chunks"));
}

TEST_F(FileChunksTest, WhatNeverBecameAFileIsDroppedAfterAWeek) {
  pushOnePiece();
  ward_ = test::makeWard();
  (void)pushWard(kOther);
  EXPECT_EQ(unused(), "1");
  (void)sql("UPDATE chunks SET sent_at = sent_at - interval '8 days'");
  drive(1.0);
  (void)pushWard(kOther);
  EXPECT_EQ(unused(), "0");
}

}  // namespace
}  // namespace wardslam::fleet
