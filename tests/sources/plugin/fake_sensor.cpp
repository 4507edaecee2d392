/// A camera with every trouble there is, chosen in its section of the .ini file.

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/core/initializer.h>
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/obs/CObservationIMU.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "../scan_maker.h"

namespace wardslam::test {

class FakeSensor : public mrpt::hwdrivers::CGenericSensor {
  DEFINE_GENERIC_SENSOR(FakeSensor)

 public:
  FakeSensor() = default;

  void initialize() override {
    if (!onlyWhile_.empty() && !std::filesystem::exists(onlyWhile_)) throw std::runtime_error("no fake camera found");
  }

  void doProcess() override {
    const bool isTrouble = ++number_ > goodFrames_;
    if (isTrouble && trouble_ == "hangs") std::this_thread::sleep_for(std::chrono::hours(1));
    if (isTrouble && trouble_ == "throws") throw std::runtime_error("the plug was pulled");
    if (isTrouble && trouble_ == "crashes") std::abort();  // as a failed assertion of COpenNI2Sensor does
    const bool resizes = isTrouble && trouble_ == "resizes";
    auto scan = makeScan(number_, (resizes ? 2 : 1) * width_px_, (resizes ? 2 : 1) * height_px_);
    scan->timestamp = mrpt::Clock::now();
    const bool isOnce = number_ == goodFrames_ + 1;
    if (isTrouble && (trouble_ == "clock_set_back" || (isOnce && trouble_ == "clock_set_back_once"))) {
      scan->timestamp -= std::chrono::hours(1);
    }
    if (isTrouble && (trouble_ == "depth_only" || (isOnce && trouble_ == "depth_only_once"))) {
      scan->hasIntensityImage = false;
    }
    if (trouble_ == "talks") {
      auto imu = mrpt::obs::CObservationIMU::Create();
      imu->timestamp = scan->timestamp;
      appendObservation(imu);
      std::puts("drivers print what they like");
    }
    appendObservation(scan);
  }

 protected:
  void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini, const std::string& section) override {
    trouble_ = ini.read_string(section, "trouble", "none");
    width_px_ = ini.read_int(section, "width", width_px_);
    height_px_ = ini.read_int(section, "height", height_px_);
    goodFrames_ = ini.read_int(section, "good_frames", 5);
    onlyWhile_ = ini.read_string(section, "only_while", "");
  }

 private:
  std::string trouble_;
  std::string onlyWhile_;
  int width_px_ = 32;
  int height_px_ = 24;
  int goodFrames_ = 0;
  int number_ = 0;
};

}  // namespace wardslam::test

IMPLEMENTS_GENERIC_SENSOR(FakeSensor, wardslam::test)

MRPT_INITIALIZER(registerFakeSensor) { wardslam::test::FakeSensor::doRegister(); }
