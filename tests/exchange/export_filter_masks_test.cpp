#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/fleet_export.h"

namespace wardslam::exchange {
namespace {

using mapping::ZoneType;

/// A plan of 4 x 2 cells of half a metre from (1, 2) on.
class ExportFilterMasksTest : public testing::Test {
 protected:
  ExportFilterMasksTest() {
    map_.floorPlan.resolution_m = 0.5;
    map_.floorPlan.origin_m = {1.0, 2.0};
    map_.floorPlan.cells = cv::Mat(2, 4, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  }

  /// Values as a map server of Nav2 in raw mode reads them, the first row with the least y.
  [[nodiscard]] std::vector<int> valuesOf(const char* image) const {
    cv::Mat pixels = cv::imread((folder_.path() / image).string(), cv::IMREAD_UNCHANGED);
    cv::flip(pixels, pixels, 0);
    return {pixels.begin<unsigned char>(), pixels.end<unsigned char>()};
  }
  static std::vector<Eigen::Vector2d> box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }

  mapping::SemanticMap map_;
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "mask.yaml";
};

TEST_F(ExportFilterMasksTest, ForbiddenZonesAreKeptOut) {
  map_.zones = {{"no", box(1, 2.5, 2, 3), ZoneType::Forbidden}, {"ward", box(0, 0, 9, 9)}};
  exportKeepoutMask(map_, file_);
  EXPECT_EQ(valuesOf("mask.pgm"), (std::vector<int>{0, 0, 0, 0, 100, 100, 0, 0}));
  const YAML::Node yaml = YAML::LoadFile(file_.string());
  EXPECT_EQ(yaml["mode"].as<std::string>(), "raw");
  EXPECT_EQ(yaml["image"].as<std::string>(), "mask.pgm");
  EXPECT_EQ(yaml["resolution"].as<double>(), 0.5);
  EXPECT_EQ(yaml["origin"].as<std::vector<double>>(), (std::vector<double>{1.0, 2.0, 0.0}));
  for (const char* key : {"negate", "occupied_thresh", "free_thresh"}) EXPECT_TRUE(yaml[key]) << key;
}

/// The fastest zone has 100, so the value is a hundredth of 0.8 m/s.
TEST_F(ExportFilterMasksTest, SlowZonesHaveTheirShareOfTheFastest) {
  map_.zones = {{"slower", box(1.5, 2, 2.5, 2.5), ZoneType::Slow, 0.2}, {"slow", box(1, 2, 2, 3), ZoneType::Slow, 0.8}};
  exportSpeedMask(map_, file_);
  EXPECT_EQ(valuesOf("mask.pgm"), (std::vector<int>{100, 25, 25, 0, 100, 100, 0, 0})) << "of two, the slower counts";
  const auto info = YAML::LoadFile(
      (folder_.path() / "mask.filter_info.yaml").string())["costmap_filter_info_server"]["ros__parameters"];
  EXPECT_EQ(info["type"].as<int>(), 2) << "speed limit in m/s";
  EXPECT_EQ(info["base"].as<double>(), 0.0);
  EXPECT_NEAR(info["multiplier"].as<double>(), 0.008, 1e-9);
}

/// Rounded down, a robot goes slower and not faster than it may; and not 0, which is no limit.
TEST_F(ExportFilterMasksTest, LimitsAreRoundedDownButForTheSlowest) {
  map_.zones = {{"a", box(1, 2, 1.5, 3), ZoneType::Slow, 1.0},
                {"b", box(1.5, 2, 2, 3), ZoneType::Slow, 0.119},
                {"c", box(2, 2, 2.5, 3), ZoneType::Slow, 0.001}};
  exportSpeedMask(map_, file_);
  EXPECT_EQ(valuesOf("mask.pgm"), (std::vector<int>{100, 11, 1, 0, 100, 11, 1, 0}));
}

TEST_F(ExportFilterMasksTest, WithoutAFloorPlanThereIsNoMask) {
  map_.floorPlan = {};
  EXPECT_THROW(exportKeepoutMask(map_, file_), core::InputError);
  EXPECT_THROW(exportSpeedMask(map_, file_), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
