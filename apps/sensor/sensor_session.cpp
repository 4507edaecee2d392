#include "sensor_session.h"

#include <mrpt/config.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/hwdrivers/COpenNI2Generic.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/system/os.h>

#include <chrono>
#include <regex>
#include <thread>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/sources/sensor_configuration.h"

namespace wardslam::apps {
namespace {

using mrpt::hwdrivers::CGenericSensor;
using sources::SensorConfiguration;
using sources::SensorMessage;

/// MRPT's classes that yield RGB-D observations, for suggestions; it has no list of them.
const std::vector<std::string> kRgbdDrivers = {"COpenNI2Sensor", "CKinect", "CMyntEyeCamera", "CSwissRanger3DCamera"};

std::string withoutFullStop(std::string sentence) {
  while (!sentence.empty() && sentence.back() == '.') sentence.pop_back();
  return sentence;
}

/// MRPT's exceptions carry place and call stack; only the sentence is for people.
std::string sentenceOf(const std::exception& error) {
  const std::string text = error.what();
  static const std::regex kMessage(R"(Message:\s*([^\n]*\S))");
  static const std::regex kPlace(R"(^\S+:\d+: \[[^\]]*\]\s*([^\n]*\S))");
  std::smatch match;
  if (std::regex_search(text, match, kMessage) || std::regex_search(text, match, kPlace))
    return withoutFullStop(match[1].str());
  return withoutFullStop(text.substr(0, text.find('\n')));
}

void loadPlugins(const std::vector<std::filesystem::path>& plugins) {
  for (const auto& plugin : plugins) {
    std::string error;
    if (!mrpt::system::loadPluginModule(std::filesystem::absolute(plugin).string(), error)) {
      throw core::InputError(plugin.string() + ": cannot be loaded as a plug-in: " + error);
    }
  }
}

/// What the drivers' own sentences leave out.
std::string adviceFor(const std::string& driver) {
  if (driver == "CKinect") {
    return " (CKinect needs an MRPT built with libfreenect, which Debian's is not; cameras of the Xtion, PrimeSense "
           "and "
           "Orbbec kind work there with COpenNI2Sensor)";
  }
  if (driver == "COpenNI2Sensor") {
    return " (is the camera plugged in, may this user use it, and has it this width, height and fps?)";
  }
  return {};
}

CGenericSensor::Ptr create(const SensorConfiguration& sensor) {
  CGenericSensor::Ptr driver;
  try {
    driver = CGenericSensor::createSensorPtr(sensor.driver);
  } catch (const std::exception& error) {
    throw core::InputError(sentenceOf(error) + adviceFor(sensor.driver));
  }
  if (driver) return driver;
  throw core::InputError("driver = " + sensor.driver + " is no sensor class of MRPT or of a plug-in; did you mean '" +
                         core::nearestName(sensor.driver, kRgbdDrivers) + "'?");
}

/// COpenNI2Sensor takes it that there is a camera, and ends the process later when there is none.
void requireOpenNi2Device(const CGenericSensor& driver) {
  const auto* openNi2 = dynamic_cast<const mrpt::hwdrivers::COpenNI2Generic*>(&driver);
  if (openNi2 != nullptr && openNi2->getNumDevices() == 0) {
    throw std::runtime_error("no OpenNI2 camera was found");
  }
}

void open(CGenericSensor& driver, const SensorConfiguration& sensor) {
  const mrpt::config::CConfigFile ini(sensor.file.string());
  driver.loadConfig(ini, sensor.section);
  driver.initialize();
  requireOpenNi2Device(driver);
}

/// False: nobody listens any more.
bool sendObservations(CGenericSensor& driver, const MessageSink& send) {
  for (const auto& [stamp, object] : driver.getObservations()) {
    const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(object);
    if (!scan) continue;  // accelerometers and the like
    if (!send({SensorMessage::Kind::Observation, sources::packObservation(*scan)})) return false;
  }
  return true;
}

void run(const SensorRequest& request, const MessageSink& send, const std::atomic<bool>& stop) {
  loadPlugins(request.plugins);
  const auto sensor = sources::readSensorConfiguration(request.file, request.section);
  try {
    // On the heap and not destroyed after trouble: destructors of drivers throw then, before the reason could be told.
    auto& driver = *new CGenericSensor::Ptr(create(sensor));
    open(*driver, sensor);
    const std::chrono::duration<double> period(1.0 / sensor.process_rate_hz);
    while (!stop) {
      const auto next = std::chrono::steady_clock::now() + period;
      driver->doProcess();
      if (!sendObservations(*driver, send)) return;
      std::this_thread::sleep_until(next);
    }
    driver.reset();
  } catch (const core::InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(sentenceOf(error) + adviceFor(sensor.driver));
  }
}

}  // namespace

void grab(const SensorRequest& request, const MessageSink& send, const std::atomic<bool>& stop) {
  try {
    run(request, send, stop);
  } catch (const core::InputError& error) {
    static_cast<void>(send({SensorMessage::Kind::Refusal, error.what()}));
  } catch (const std::exception& error) {
    static_cast<void>(send({SensorMessage::Kind::Failure, error.what()}));
  }
}

}  // namespace wardslam::apps
