#pragma once

#include <mrpt/hwdrivers/CGenericSensor.h>

#include <memory>
#include <string>

namespace wardslam::mrpt_sensor {

/// An RGB-D camera whose scans come with what WardSLAM's filters found out: any other CGenericSensor, asked in a
/// process of its own, and the filters behind it. For rawlog-grabber:
///
///     [CAMERA]
///     driver       = CSemanticRGBDSensor
///     process_rate = 90
///     sensorLabel  = CAMERA
///     camera       = OPENNI2     ; section of the camera, with its driver and parameters
///     camera_plugin = /full/path/of.so    ; library with the class of the camera, where it is not MRPT's own
///     filters      = FILTERS     ; section with options of WardSLAM (pipeline::readSlamOptions); none: the defaults
///     mode         = propagate   ; masks of a slow network are carried to newer images; else scans wait for them
///     companion    = false       ; add a CObservationSemanticRGBD of the same time and label CAMERA_SEM
///
/// Both sections named have rawlog-grabber-ignore = true. Images come as fast as the filters work; others are skipped.
class CSemanticRGBDSensor : public mrpt::hwdrivers::CGenericSensor {
  DEFINE_GENERIC_SENSOR(CSemanticRGBDSensor)

 public:
  CSemanticRGBDSensor();
  ~CSemanticRGBDSensor() override;

  /// Returns when images come. Throws core::InputError, also for what was wrong in the configuration.
  void initialize() override;

  /// At most one scan; none when the camera is away. Throws core::InputError when it is lost for good.
  void doProcess() override;

 protected:
  void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini, const std::string& section) override;

 private:
  class Work;
  std::unique_ptr<Work> work_;
  std::string trouble_ =
      "CSemanticRGBDSensor: load a configuration before initialising it";  ///< While there is no work_.
};

}  // namespace wardslam::mrpt_sensor
