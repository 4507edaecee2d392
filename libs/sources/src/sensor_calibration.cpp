#include "sensor_calibration.h"

#include <mrpt/config/CConfigFile.h>

#include <set>
#include <string>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using mrpt::config::CConfigFile;

struct Size {
  int width_px = 0;
  int height_px = 0;

  [[nodiscard]] bool operator!=(const Size& other) const {
    return width_px != other.width_px || height_px != other.height_px;
  }
  [[nodiscard]] std::string text() const { return std::to_string(width_px) + "x" + std::to_string(height_px); }
};

void requireFittingSize(const CConfigFile& ini, const SensorConfiguration& sensor, const std::string& camera,
                        const Size& mode) {
  const std::string section = sensor.section + camera;
  std::vector<int> resolution;
  ini.read_vector(section, "resolution", std::vector<int>(), resolution);
  if (resolution.size() != 2) return;
  const Size calibrated{resolution[0], resolution[1]};
  if (!(calibrated != mode)) return;
  throw core::InputError(sensor.place + ": asks for images of " + mode.text() + " pixels, but [" + section +
                         "] is the calibration of images of " + calibrated.text() + "; write the calibration of " +
                         mode.text() + " there (resolution, fx, fy, cx, cy), or ask for " + calibrated.text());
}

void requireDepth(const CConfigFile& ini, const SensorConfiguration& sensor) {
  static const std::set<std::string> kColorOnly = {"opencv", "cv", "dc1394", "ffmpeg", "flycap", "image_dir"};
  const std::string grabber = ini.read_string(sensor.section, "grabber_type", "");
  if (sensor.driver == "CCameraSensor" && kColorOnly.count(grabber) > 0) {
    throw core::InputError(sensor.place + ": CCameraSensor with grabber_type = " + grabber +
                           " takes colour images without depth; use the camera's own driver (COpenNI2Sensor for " +
                           "RGB-D cameras that OpenNI2 knows)");
  }
  if (sensor.driver == "COpenNI2_RGBD360") {
    throw core::InputError(sensor.place +
                           ": COpenNI2_RGBD360 gives the images of several cameras as one observation, " +
                           "which is not used; take one of them with COpenNI2Sensor");
  }
  for (const char* key : {"grab_depth", "grab_image"}) {
    if (ini.read_bool(sensor.section, key, true)) continue;
    throw core::InputError(sensor.place + ": " + key +
                           " = false, but both colour and depth are needed; set it to true");
  }
}

}  // namespace

void requireUsableSensor(const SensorConfiguration& sensor, bool hasCamera) {
  const CConfigFile ini(sensor.file.string());
  requireDepth(ini, sensor);
  if (hasCamera || !ini.keyExists(sensor.section, "width")) return;
  const Size mode{ini.read_int(sensor.section, "width", 0), ini.read_int(sensor.section, "height", 0)};
  for (const char* camera : {"_LEFT", "_RIGHT"}) requireFittingSize(ini, sensor, camera, mode);
}

}  // namespace wardslam::sources
