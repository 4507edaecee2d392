#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstring>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

/// A point of the PCD; PCL fills the fields by their names.
struct ExportedPcdPoint {
  float x, y, z;
  std::uint32_t label;
  std::uint32_t instance;
};
POINT_CLOUD_REGISTER_POINT_STRUCT(ExportedPcdPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(std::uint32_t, label,
                                                                          label)(std::uint32_t, instance, instance))

namespace wardslam::exchange {
namespace {

/// A field of one point, as PCL read it.
template <class Value>
Value valueAt(const pcl::PCLPointCloud2& cloud, const std::string& name, std::size_t number) {
  const int field = pcl::getFieldIndex(cloud, name);
  if (field < 0 || cloud.fields[static_cast<std::size_t>(field)].datatype != pcl::traits::asEnum_v<Value>) {
    throw std::runtime_error("no such field: " + name);
  }
  Value value{};
  std::memcpy(&value, &cloud.data[number * cloud.point_step + cloud.fields[static_cast<std::size_t>(field)].offset],
              sizeof value);
  return value;
}

class ExportCloudTest : public testing::Test {
 protected:
  /// Point 14 of the second tile is number 64 of all: of a chair, object 1.
  static constexpr std::size_t kNumber = 64;
  const mapping::SemanticPoint& point() const { return ward_.cloud.at(2).points.at(14); }
  Eigen::Vector3f expected_map_m() const {
    return (ward_.keyframes.at(2).T_map_cam * point().p_cam_m.cast<double>()).cast<float>();
  }

  test::TemporaryFolder folder_;
  mapping::SemanticMap ward_ = test::makeWard();
};

TEST_F(ExportCloudTest, PclReadsThePlyWithColoursAndLabels) {
  const std::string file = (folder_.path() / "ward.ply").string();
  exportPly(ward_, file);
  pcl::PointCloud<pcl::PointXYZRGBL> labelled;
  ASSERT_EQ(pcl::io::loadPLYFile(file, labelled), 0);
  ASSERT_EQ(labelled.size(), 150U);
  EXPECT_TRUE(labelled[kNumber].getVector3fMap().isApprox(expected_map_m(), 1e-5F));
  EXPECT_EQ(labelled[kNumber].r, 14);
  EXPECT_EQ(labelled[kNumber].g, 100);
  EXPECT_EQ(labelled[kNumber].b, 200);
  EXPECT_EQ(labelled[kNumber].label, std::uint32_t{test::kChair});
  EXPECT_EQ(labelled[kNumber + 1].label, 0U);
}

TEST_F(ExportCloudTest, ThePlyHasClassAndInstanceByTheNamesCloudCompareTakes) {
  const std::string file = (folder_.path() / "ward.ply").string();
  exportPly(ward_, file);
  pcl::PCLPointCloud2 all;
  ASSERT_EQ(pcl::io::loadPLYFile(file, all), 0);
  EXPECT_EQ(valueAt<std::uint8_t>(all, "scalar_class", kNumber), test::kChair);
  EXPECT_EQ(valueAt<std::uint32_t>(all, "scalar_instance", kNumber), 1U);
  EXPECT_EQ(valueAt<std::uint8_t>(all, "scalar_class", kNumber + 1), 0);
  EXPECT_EQ(valueAt<std::uint32_t>(all, "scalar_instance", kNumber + 1), 0U);
}

TEST_F(ExportCloudTest, PclReadsThePcdWithColoursLabelsAndInstances) {
  const std::string file = (folder_.path() / "ward.pcd").string();
  exportPcd(ward_, file);
  pcl::PointCloud<pcl::PointXYZRGBL> labelled;
  ASSERT_EQ(pcl::io::loadPCDFile(file, labelled), 0);
  ASSERT_EQ(labelled.size(), 150U);
  EXPECT_TRUE(labelled[kNumber].getVector3fMap().isApprox(expected_map_m(), 1e-5F));
  EXPECT_EQ(labelled[kNumber].r, 14);
  EXPECT_EQ(labelled[kNumber].g, 100);
  EXPECT_EQ(labelled[kNumber].b, 200);
  EXPECT_EQ(labelled[kNumber].label, std::uint32_t{test::kChair});

  pcl::PointCloud<ExportedPcdPoint> instances;
  ASSERT_EQ(pcl::io::loadPCDFile(file, instances), 0);
  EXPECT_EQ(instances[kNumber].instance, 1U);
}

TEST_F(ExportCloudTest, AnEmptyCloudIsAFileWithoutPoints) {
  exportPly({}, folder_.path() / "empty.ply");
  pcl::PCLPointCloud2 cloud;
  pcl::PLYReader reader;
  EXPECT_EQ(reader.read((folder_.path() / "empty.ply").string(), cloud), 0);
  EXPECT_EQ(cloud.width * cloud.height, 0U);
}

TEST_F(ExportCloudTest, WhatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(exportPly(ward_, folder_.path() / "missing" / "ward.ply"), core::InputError);
  EXPECT_THROW(exportPcd(ward_, folder_.path() / "missing" / "ward.pcd"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
