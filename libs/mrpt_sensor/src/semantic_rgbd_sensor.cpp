#include "semantic_rgbd_sensor.h"

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/system/COutputLogger.h>

#include <chrono>
#include <optional>

#include "temporary_ini.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/frame_conversion.h"
#include "wardslam/pipeline/front_end.h"
#include "wardslam/pipeline/ini_options.h"
#include "wardslam/sources/live_sensor_source.h"

IMPLEMENTS_GENERIC_SENSOR(CSemanticRGBDSensor, wardslam::mrpt_sensor)

namespace wardslam::mrpt_sensor {
namespace {

using namespace std::chrono_literals;

/// While a camera is away, the program that asks wants to be able to end.
constexpr auto kPatience = 200ms;

/// Where nothing is to segment (segmentation.type = none), what moves is told by geometry alone.
pipeline::SlamOptions readFilterOptions(const mrpt::config::CConfigFileBase& ini, const std::string& section) {
  auto options = section.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(ini, section);
  const bool isSegmented = options.segmentation.type != segmentation::SegmentationOptions::Type::None;
  const bool hasOwnFilters = !section.empty() && ini.keyExists(section, "config");
  if (!isSegmented && !hasOwnFilters) options.keepOnlyFilters("wardslam::filters::GeometricMotionFilter");
  return options;
}

pipeline::SlamOptions readOptions(const mrpt::config::CConfigFileBase& ini, const std::string& section) {
  auto options = readFilterOptions(ini, ini.read_string(section, "filters", ""));
  const std::string mode = ini.read_string(section, "mode", "");
  if (!mode.empty() && !options.setFilterParameter("wardslam::filters::SemanticDynamicFilter", "mode", mode)) {
    throw core::InputError("[" + section + "]: 'mode' says how the SemanticDynamicFilter gets its masks, but nothing " +
                           "segments: give a network in the section that 'filters' names");
  }
  return options;
}

}  // namespace

/// What there is once the configuration is known: the camera and, behind it, the filters.
class CSemanticRGBDSensor::Work {
 public:
  Work(const mrpt::config::CConfigFileBase& ini, const std::string& section)
      : ini_(ini),
        options_(readOptions(ini, section)),
        cameraPlugin_(ini.read_string(section, "camera_plugin", "")),
        hasCompanion_(ini.read_bool(section, "companion", false)) {
    const std::string camera = ini.read_string(section, "camera", "");
    if (camera.empty() || camera == section) {
      throw core::InputError("[" + section + "]: the key 'camera' must name the section of the camera");
    }
    camera_ = sources::readSensorConfiguration(ini, "the configuration", camera);
    camera_.file = ini_.path();
  }

  void open() {
    sources::LiveSensor live;
    live.sensor = camera_;
    if (!cameraPlugin_.empty()) live.plugins = {cameraPlugin_};
    live.options = options_.sources.live;
    live.stop = [this] { return Clock::now() > patienceEnds_; };
    sources::SourceOptions options;
    options.warn = [this](const std::string& sentence) { log_.logStr(mrpt::system::LVL_WARN, sentence); };
    frontEnd_.emplace(options_);
    source_.emplace(std::move(live), options);
  }

  /// A scan that the filters have annotated and, where asked for, its companion; or nothing.
  [[nodiscard]] std::vector<mrpt::serialization::CSerializable::Ptr> next(const std::string& label) {
    patienceEnds_ = Clock::now() + kPatience;
    const auto scan = source_->next();
    if (!scan) return {};
    scan->sensorLabel = label;
    try {
      const auto result = frontEnd_->process(scan);
      if (!hasCompanion_) return {scan};
      return {scan, mrpt_plugin::toObservation(result.frame, frontEnd_->labelSpace())};
    } catch (const core::FrameError& error) {
      log_.logStr(mrpt::system::LVL_WARN, error.what());
      return {};
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  TemporaryIni ini_;
  pipeline::SlamOptions options_;
  std::string cameraPlugin_;
  bool hasCompanion_;
  sources::SensorConfiguration camera_;
  mrpt::system::COutputLogger log_{"CSemanticRGBDSensor"};
  Clock::time_point patienceEnds_ = Clock::time_point::max();  ///< When opening, the source's own timeout holds.
  std::optional<pipeline::FrontEnd> frontEnd_;
  std::optional<sources::LiveSensorSource> source_;
};

CSemanticRGBDSensor::CSemanticRGBDSensor() = default;
CSemanticRGBDSensor::~CSemanticRGBDSensor() = default;

void CSemanticRGBDSensor::loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini,
                                                    const std::string& section) {
  try {
    work_ = std::make_unique<Work>(ini, section);
  } catch (const core::InputError& error) {
    trouble_ = error.what();  // MRPT would take the sentence apart and put a call stack under it; initialize() tells it
  }
}

void CSemanticRGBDSensor::initialize() {
  if (!work_) throw core::InputError(trouble_);
  m_state = ssInitializing;
  work_->open();
}

void CSemanticRGBDSensor::doProcess() {
  const auto observations = work_->next(m_sensorLabel);
  if (observations.empty()) return;
  m_state = ssWorking;
  appendObservations(observations);
}

}  // namespace wardslam::mrpt_sensor
