#include "sensor_calibration.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class SensorCalibration : public ::testing::Test {
 protected:
  void check(const std::string& text, bool hasCamera = false) const {
    requireUsableSensor(readSensorConfiguration(folder.write("s.ini", text)), hasCamera);
  }
  test::TemporaryFolder folder;
  const std::string mode =
      "[CAM]\ndriver = COpenNI2Sensor\nprocess_rate = 30\nwidth = 640 // px\nheight = 480\nfps = 30\n";
};

TEST_F(SensorCalibration, MustBeThatOfTheMode) {
  EXPECT_NO_THROW(check(mode));
  EXPECT_NO_THROW(check(mode + "[CAM_LEFT]\nrawlog-grabber-ignore = true\nresolution = [640 480]\n"));
  const std::string other = mode + "[CAM_RIGHT]\nrawlog-grabber-ignore = true\nresolution = [640 488]\n";
  EXPECT_THAT([&] { check(other); },
              ThrowsMessage<core::InputError>(
                  AllOf(HasSubstr("[CAM]"), HasSubstr("640x480"), HasSubstr("[CAM_RIGHT]"), HasSubstr("640x488"))));
  EXPECT_NO_THROW(check(other, true));
}

TEST_F(SensorCalibration, IsOfNoUseWithoutDepth) {
  EXPECT_THAT([&] { check(mode + "grab_depth = false\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("[CAM]"), HasSubstr("grab_depth = false"))));
  EXPECT_THAT([&] { check("[W]\ndriver = CCameraSensor\nprocess_rate = 90\ngrabber_type = opencv\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("[W]"), HasSubstr("without depth"))));
  EXPECT_THAT([&] { check("[R]\ndriver = COpenNI2_RGBD360\nprocess_rate = 1\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("[R]"), HasSubstr("take one of them"))));
}

}  // namespace
}  // namespace wardslam::sources
