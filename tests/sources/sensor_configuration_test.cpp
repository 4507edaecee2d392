#include "wardslam/sources/sensor_configuration.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class SensorConfigurationFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path write(const std::string& text) const { return folder.write("s.ini", text); }
  void expectError(const std::string& text, const std::string& message, const std::string& section = {}) const {
    const auto file = write(text);
    EXPECT_THAT([&] { static_cast<void>(readSensorConfiguration(file, section)); },
                ThrowsMessage<core::InputError>(file.string() + ": " + message));
  }

  test::TemporaryFolder folder;
};

TEST_F(SensorConfigurationFile, NamesSectionDriverAndRate) {
  const auto file = write(
      "[global]\nrawlog_prefix = x\n[KINECT]\ndriver = CKinect // comment\nprocess_rate = 200 // Hz (max)\n"
      "[KINECT_LEFT]\nrawlog-grabber-ignore = true\n");
  const auto sensor = readSensorConfiguration(file);
  EXPECT_EQ(sensor.section, "KINECT");
  EXPECT_EQ(sensor.driver, "CKinect");
  EXPECT_EQ(sensor.process_rate_hz, 200.0);
  EXPECT_EQ(sensor.place, file.string() + ": [KINECT]");
}

TEST_F(SensorConfigurationFile, HasOneSensorUnlessToldWhich) {
  const std::string two = "[FRONT]\ndriver = X\nprocess_rate = 1\n[REAR]\ndriver = Y\nprocess_rate = 2\n";
  EXPECT_EQ(readSensorConfiguration(write(two), "REAR").driver, "Y");
  expectError(two, "holds several sensors (FRONT, REAR); say which with --sensor");
  expectError(two, "has no sensor [REER]; did you mean [REAR]?", "REER");
  expectError("[global]\nx = 1\n", "holds no section for a sensor, like [OPENNI2]");
}

TEST_F(SensorConfigurationFile, NamesWhatIsMissing) {
  expectError("[A]\ndrivr = X\n", "[A]: the key 'driver' is missing (the nearest one there is 'drivr')");
  expectError("[A]\ndriver = X\n", "[A]: the key 'process_rate' is missing (the nearest one there is 'driver')");
  expectError("[A]\ndriver = X\nprocess_rate = 0\n", "[A]: process_rate must be a number of Hz above 0");
  expectError("[A]\ndriver = COpenNI2Sensor\nprocess_rate = 9\nwidth = 640\nhigth = 480\nfps = 30\n",
              "[A]: the key 'height' is missing (the nearest one there is 'higth')");
}

TEST_F(SensorConfigurationFile, MustBeAnIniFile) {
  const auto file = write("[A]\ndriver = $env{HOME\nprocess_rate = 1\n");
  EXPECT_THAT([&] { static_cast<void>(readSensorConfiguration(file)); },
              ThrowsMessage<core::InputError>(HasSubstr("s.ini: is no .ini file that can be read: ")));
}

TEST_F(SensorConfigurationFile, MustBeThere) {
  EXPECT_THAT([] { static_cast<void>(readSensorConfiguration("/no/such.ini")); },
              ThrowsMessage<core::InputError>("/no/such.ini: no such file"));
}

TEST_F(SensorConfigurationFile, ComesWithTheProgram) {
  EXPECT_EQ(readSensorConfiguration(core::findDataFile("sensors/openni2.ini")).driver, "COpenNI2Sensor");
  EXPECT_EQ(readSensorConfiguration(core::findDataFile("sensors/kinect.ini")).driver, "CKinect");
}

TEST_F(SensorConfigurationFile, ThatComesWithTheProgramLosesNextToNothingAtTheEndOfARecording) {
  // rawlog-grabber throws away what it grabbed in its last one or two periods.
  for (const char* name : {"sensors/openni2.ini", "sensors/kinect.ini", "sensors/semantic_openni2.ini"}) {
    EXPECT_THAT(test::readText(core::findDataFile(name)), HasSubstr("\nGRABBER_PERIOD_MS        = 20\n")) << name;
  }
}

TEST_F(SensorConfigurationFile, OfMrptIsUnderstood) {
  const std::filesystem::path stock = "/usr/share/mrpt/config_files/rawlog-grabber/openNI2.ini";
  if (!std::filesystem::exists(stock)) GTEST_SKIP() << stock << " comes with the Debian package mrpt-apps";
  const auto sensor = readSensorConfiguration(stock);
  EXPECT_EQ(sensor.section, "OPENNI2");
  EXPECT_EQ(sensor.driver, "COpenNI2Sensor");
}

TEST_F(SensorConfigurationFile, IsToldFromRecordings) {
  EXPECT_TRUE(isSensorConfiguration("a/openni2.ini"));
  EXPECT_FALSE(isSensorConfiguration("a/ward.rawlog"));
  EXPECT_FALSE(isSensorConfiguration(folder.path()));
}

}  // namespace
}  // namespace wardslam::sources
