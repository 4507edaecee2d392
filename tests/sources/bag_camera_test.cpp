#include "bag_camera.h"

#include <gmock/gmock.h>

#include "support/complaint.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

bags::CameraInfo sound() {
  bags::CameraInfo info;
  info.width_px = 640;
  info.height_px = 480;
  info.distortionModel = "plumb_bob";
  info.d = {0.1, -0.2, 0.001, 0.002, 0.3};
  info.k = {500, 0, 320, 0, 501, 240, 0, 0, 1};
  info.p = {450, 0, 310, 0, 0, 451, 230, 0, 0, 0, 1, 0};
  return info;
}

std::string complaint(const bags::CameraInfo& info, const std::string& topic = "/c/image_raw") {
  return test::complaintOf([&] { return cameraOf(info, topic, "f.bag: /c"); });
}

TEST(BagCamera, RawImagesHaveTheMatrixKAndTheLens) {
  const core::CameraModel camera = cameraOf(sound(), "/c/image_raw", "");
  EXPECT_EQ(camera.fx_px, 500);
  EXPECT_EQ(camera.fy_px, 501);
  EXPECT_EQ(camera.cx_px, 320);
  EXPECT_EQ(camera.cy_px, 240);
  EXPECT_EQ(camera.k1, 0.1);
  EXPECT_EQ(camera.k2, -0.2);
  EXPECT_EQ(camera.p1, 0.001);
  EXPECT_EQ(camera.p2, 0.002);
  EXPECT_EQ(camera.k3, 0.3);
}

TEST(BagCamera, RectifiedImagesHaveTheMatrixPAndNoLens) {
  for (const char* topic : {"/c/image_rect_color", "/c/image_rect/compressed"}) {
    const core::CameraModel camera = cameraOf(sound(), topic, "");
    EXPECT_EQ(camera.fx_px, 450);
    EXPECT_EQ(camera.cy_px, 230);
    EXPECT_FALSE(camera.hasDistortion());
  }
}

TEST(BagCamera, RefusesOtherLensesAndNamesTheRemedy) {
  bags::CameraInfo info = sound();
  info.distortionModel = "rational_polynomial";
  info.d = {0.1, 0.2, 0, 0, 0.3, 0.4, 0.5, 0.6};
  EXPECT_THAT(complaint(info), AllOf(HasSubstr("rational_polynomial"), HasSubstr("image_proc"), HasSubstr("--camera")));
  EXPECT_EQ(complaint(info, "/c/image_rect_color"), "");  // rectified
  info.d = {0.1, 0.2, 0, 0, 0.3, 0, 0, 0};
  EXPECT_EQ(complaint(info), "");  // the same as plumb_bob
  info.distortionModel = "equidistant";
  info.d = {0.1, 0.2, 0, 0};
  EXPECT_THAT(complaint(info), HasSubstr("equidistant"));
  info.d = {0, 0, 0, 0};
  EXPECT_EQ(complaint(info), "");
}

TEST(BagCamera, KnowsTheLensesOfRealSense) {
  bags::CameraInfo info = sound();
  info.distortionModel = "Brown Conrady";
  EXPECT_EQ(cameraOf(info, "/device_0/sensor_1/Color_0/image/data", "").k2, -0.2);
  info.distortionModel = "Inverse Brown Conrady";
  info.d = {-0.05, 0.06, 0.0, 0.0, -0.02};
  EXPECT_NEAR(cameraOf(info, "/device_0/sensor_1/Color_0/image/data", "").k1, 0.05, 0.01);
  info.d = {-0.9, 0.0, 0.0, 0.0, 0.0};
  EXPECT_THAT(complaint(info), AllOf(HasSubstr("Inverse Brown Conrady"), HasSubstr("--camera")));
  info.distortionModel = "Kannala Brandt4";
  EXPECT_THAT(complaint(info), HasSubstr("Kannala Brandt4"));
}

TEST(BagCamera, RefusesWhatIsNotCalibratedOrNotWhole) {
  bags::CameraInfo info = sound();
  info.k = {};
  EXPECT_THAT(complaint(info), AllOf(HasSubstr("not calibrated"), HasSubstr("--camera")));
  info = sound();
  info.k[2] = 700;
  EXPECT_THAT(complaint(info), HasSubstr("principal point"));
  info = sound();
  info.binning_x = 2;
  EXPECT_THAT(complaint(info), HasSubstr("binned"));
  info = sound();
  info.roi_px = {10, 0, 400, 600};
  EXPECT_THAT(complaint(info), HasSubstr("part of what the camera sees"));
  info.roi_px = {0, 0, 480, 640};
  EXPECT_EQ(complaint(info), "");
}

}  // namespace
}  // namespace wardslam::sources
