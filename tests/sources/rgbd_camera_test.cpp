#include "wardslam/sources/rgbd_camera.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string kPinhole = "width: 640\nheight: 480\nfx: 525.0\nfy: 520\ncx: 319.5\ncy: 239.5\n";

class RgbdCameraFile : public ::testing::Test {
 protected:
  [[nodiscard]] RgbdCamera read(const std::string& text) const {
    return readRgbdCamera(folder.write("camera.yaml", text));
  }
  test::TemporaryFolder folder;
};

TEST_F(RgbdCameraFile, TakesItsKeys) {
  const RgbdCamera camera = read(kPinhole + "k1: 0.2\ndepth_factor: 1000\nfps: 15\n");
  EXPECT_EQ(camera.color.width_px, 640);
  EXPECT_EQ(camera.color.fy_px, 520.0);
  EXPECT_EQ(camera.color.k1, 0.2);
  EXPECT_EQ(camera.depth_units_per_m, 1000.0);
  EXPECT_EQ(camera.rate_hz, 15.0);
}

TEST_F(RgbdCameraFile, HasTumsDepthUnitByDefault) {
  EXPECT_EQ(read(kPinhole).depth_units_per_m, 5000.0);
  EXPECT_FALSE(read(kPinhole).color.hasDistortion());
}

TEST_F(RgbdCameraFile, MustNameItsFocalLength) {
  EXPECT_THAT([&] { return read("width: 640\nheight: 480\nfy: 1\ncx: 1\ncy: 1\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml"), HasSubstr("'fx' is missing"))));
}

TEST_F(RgbdCameraFile, RefusesANegativeFocalLength) {
  EXPECT_THAT([&] { return read("width: 640\nheight: 480\nfx: -525\nfy: 1\ncx: 1\ncy: 1\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("camera.yaml:3: 'fx': -525 is outside")));
}

TEST_F(RgbdCameraFile, NamesTheNearestKeyOfAMisspeltOne) {
  EXPECT_THAT([&] { return read(kPinhole + "depth_facter: 5000\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml:7"), HasSubstr("'depth_factor'"))));
}

TEST_F(RgbdCameraFile, RefusesAnImpossibleDepthUnit) {
  EXPECT_THAT([&] { return read(kPinhole + "depth_factor: 0\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("depth_factor")));
}

TEST(ShippedCameras, AreTheOnesTumPublished) {
  const auto readShipped = [](const std::string& name) {
    return readRgbdCamera(core::findDataFile("cameras/" + name + ".yaml"));
  };
  const auto camera1 = readShipped("tum_freiburg1").color;
  EXPECT_EQ(camera1.fx_px, 517.3);
  EXPECT_EQ(camera1.fy_px, 516.5);
  EXPECT_EQ(camera1.cx_px, 318.6);
  EXPECT_EQ(camera1.cy_px, 255.3);
  EXPECT_EQ(camera1.k2, -0.9531);
  EXPECT_EQ(camera1.k3, 1.1633);
  EXPECT_EQ(readShipped("tum_freiburg2").color.p2, -0.0001);
  EXPECT_EQ(readShipped("tum_freiburg3").color.fy_px, 539.2);
  EXPECT_FALSE(readShipped("tum_freiburg3").color.hasDistortion());
  EXPECT_EQ(readShipped("kinect_default").color.fx_px, 525.0);
}

TEST(ShippedCameras, AreListed) {
  EXPECT_THAT(listCameraFiles(), AllOf(HasSubstr("kinect_default.yaml, "), HasSubstr("tum_freiburg2.yaml")));
}

}  // namespace
}  // namespace wardslam::sources
