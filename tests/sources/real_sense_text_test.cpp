#include "real_sense_text.h"

#include <gtest/gtest.h>

#include "wardslam/bags/bag_damage.h"

namespace wardslam::sources {
namespace {

const std::string kCamera =
    "width=640;height=480;fx=604.5;ppx=318.25;fy=605.5;ppy=241.75;model=Inverse Brown Conrady;"
    "coeffs=0.125,-0.25,0.5,0,0";

TEST(RealSenseText, TellsTheCamera) {
  const bags::CameraInfo info = realSenseCamera(kCamera);
  EXPECT_EQ(info.width_px, 640U);
  EXPECT_EQ(info.height_px, 480U);
  EXPECT_EQ(info.k, (std::array<double, 9>{604.5, 0, 318.25, 0, 605.5, 241.75, 0, 0, 1}));
  EXPECT_EQ(info.distortionModel, "Inverse Brown Conrady");
  EXPECT_EQ(info.d, (std::vector<double>{0.125, -0.25, 0.5, 0, 0}));
}

// A quarter turn about z: x becomes y, so the first column is (0, 1, 0).
TEST(RealSenseText, TellsThePlaceColumnByColumn) {
  const auto T = realSensePlace("rotation=0,1.000000,0,-1.000000,0,0,0,0,1.000000;translation=0.015,0.25,-0.5");
  EXPECT_TRUE((T * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(0.015, 1.25, -0.5), 1e-12));
}

TEST(RealSenseText, TellsANumber) { EXPECT_EQ(realSenseNumber("0.000100"), 0.0001); }

TEST(RealSenseText, RefusesWhatTellsSomethingElse) {
  for (const char* text :
       {"", "width=640", "rotation=1,0,0;translation=0,0,0", "nan", "1 m",
        "rotation=2,0,0,0,1,0,0,0,1;translation=0,0,0", "rotation=1,0,0,0,1,0,0,0,-1;translation=0,0,0"}) {
    EXPECT_THROW((void)realSenseCamera(text), bags::BagDamage) << text;
    EXPECT_THROW((void)realSensePlace(text), bags::BagDamage) << text;
    EXPECT_THROW((void)realSenseNumber(text), bags::BagDamage) << text;
  }
  EXPECT_THROW((void)realSenseCamera("width=-1" + kCamera.substr(9)), bags::BagDamage);
}

}  // namespace
}  // namespace wardslam::sources
