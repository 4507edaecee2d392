#include <gtest/gtest.h>
#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CText.h>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::viewer {
namespace {

class ExportSceneTest : public testing::Test {
 protected:
  ExportSceneTest() {
    exportScene(ward_, file_);
    EXPECT_TRUE(scene_.loadFromFile(file_.string()));
  }

  mapping::SemanticMap ward_ = test::makeWard();
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "ward.3Dscene";
  mrpt::opengl::COpenGLScene scene_;
};

TEST_F(ExportSceneTest, HasTheColouredCloud) {
  const auto cloud = scene_.getByClass<mrpt::opengl::CPointCloudColoured>();
  ASSERT_TRUE(cloud);
  ASSERT_EQ(cloud->size(), 150U);
  const auto point = cloud->getPoint3Df(64);
  const Eigen::Vector3d expected =
      ward_.keyframes.at(2).T_map_cam * ward_.cloud.at(2).points.at(14).p_cam_m.cast<double>();
  EXPECT_NEAR(point.x, expected.x(), 1e-5);
  EXPECT_NEAR(point.y, expected.y(), 1e-5);
  EXPECT_NEAR(point.z, expected.z(), 1e-5);
}

TEST_F(ExportSceneTest, HasABoxWithItsNameForWhatStandsThere) {
  const auto box = std::dynamic_pointer_cast<mrpt::opengl::CBox>(scene_.getByName("object 5"));
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->getPose().x, 5.5, 1e-6);
  mrpt::math::TPoint3D low;
  mrpt::math::TPoint3D high;
  box->getBoxCorners(low, high);
  EXPECT_NEAR(high.y - low.y, 2.0, 1e-6);
  EXPECT_FALSE(scene_.getByName("object 6")) << "that chair is gone";
  bool isNamed = false;
  for (std::size_t i = 0; const auto text = scene_.getByClass<mrpt::opengl::CText>(i); ++i) {
    isNamed = isNamed || text->getString() == "bed #5";
  }
  EXPECT_TRUE(isNamed);
}

TEST_F(ExportSceneTest, HasZonesAndTheWayOfTheCamera) {
  const auto zone = std::dynamic_pointer_cast<mrpt::opengl::CSetOfLines>(scene_.getByName("zone clean zone"));
  ASSERT_TRUE(zone);
  EXPECT_EQ(zone->getLineCount(), 4U);
  const auto way = std::dynamic_pointer_cast<mrpt::opengl::CSetOfLines>(scene_.getByName("way of the camera"));
  ASSERT_TRUE(way);
  EXPECT_EQ(way->getLineCount(), 2U);
}

TEST_F(ExportSceneTest, WhatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(exportScene(ward_, folder_.path() / "missing" / "ward.3Dscene"), core::InputError);
}

}  // namespace
}  // namespace wardslam::viewer
