#include "semantic_rgbd_sensor.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include "support/complaint.h"
#include "wardslam/core/annotation.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace wardslam::mrpt_sensor {
namespace {

using mrpt::hwdrivers::CGenericSensor;
using mrpt::obs::CObservation3DRangeScan;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// As rawlog-grabber makes and sets up a sensor: by name, from text.
class SemanticSensor : public ::testing::Test {
 protected:
  SemanticSensor() { CSemanticRGBDSensor::doRegister(); }

  [[nodiscard]] static CGenericSensor::Ptr load(const std::string& keys, const std::string& cameraKeys = "",
                                                const std::string& filterKeys = "") {
    auto sensor = CGenericSensor::createSensorPtr("CSemanticRGBDSensor");
    const mrpt::config::CConfigFileMemory ini(
        "[CAMERA]\nprocess_rate = 90\nsensorLabel = WARD\nfilters = FILTERS\ncamera_plugin = " WARDSLAM_FAKE_SENSOR
        "\n" +
        keys +
        "\n[FAKE]\nrawlog-grabber-ignore = true\ndriver = FakeSensor\nprocess_rate = 30\nsensorLabel = INNER\n"
        "width = 320\nheight = 240\n" +
        cameraKeys +
        "\n[FILTERS]\nrawlog-grabber-ignore = true\nsources.live.silence_timeout = 0.3\nfeatures.key_points = 200\n" +
        filterKeys);
    sensor->loadConfig(ini, "CAMERA");
    return sensor;
  }
  /// What the sensor has to give, asked for until there is something.
  [[nodiscard]] static CGenericSensor::TListObservations grab(CGenericSensor& sensor) {
    CGenericSensor::TListObservations observations;
    while (observations.empty()) {
      sensor.doProcess();
      observations = sensor.getObservations();
    }
    return observations;
  }
};

TEST_F(SemanticSensor, YieldsAnnotatedScans) {
  const auto sensor = load("camera = FAKE");
  sensor->initialize();
  for (int i = 0; i < 3; ++i) {
    const auto observations = grab(*sensor);
    ASSERT_THAT(observations, SizeIs(1));
    const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observations.begin()->second);
    ASSERT_NE(scan, nullptr);
    EXPECT_EQ(scan->sensorLabel, "WARD");
    EXPECT_EQ(core::annotationOf(*scan).size(), cv::Size(320, 240));
    ASSERT_TRUE(scan->hasConfidenceImage);
    EXPECT_EQ(scan->confidenceImage.getWidth(), 320U);
  }
  EXPECT_EQ(sensor->getState(), CGenericSensor::ssWorking);
}

TEST_F(SemanticSensor, AddsCompanions) {
  const auto sensor = load("camera = FAKE\ncompanion = true");
  sensor->initialize();
  const auto observations = grab(*sensor);
  ASSERT_THAT(observations, SizeIs(2));
  const auto companion =
      std::dynamic_pointer_cast<mrpt_plugin::CObservationSemanticRGBD>(observations.rbegin()->second);
  ASSERT_NE(companion, nullptr);
  EXPECT_EQ(companion->sensorLabel, "WARD_SEM");
  EXPECT_EQ(observations.begin()->first, observations.rbegin()->first);
  EXPECT_EQ(companion->camera.width_px, 320);
}

TEST_F(SemanticSensor, SegmentsWithNothingSaid) {
  for (const bool isOff : {false, true}) {
    const auto sensor = load("camera = FAKE\ncompanion = true", "", isOff ? "segmentation.type = none\n" : "");
    sensor->initialize();
    const auto observations = grab(*sensor);
    ASSERT_THAT(observations, SizeIs(2));
    const auto companion =
        std::dynamic_pointer_cast<mrpt_plugin::CObservationSemanticRGBD>(observations.rbegin()->second);
    ASSERT_NE(companion, nullptr);
    EXPECT_EQ(companion->segmentation.empty(), isOff);
  }
}

TEST_F(SemanticSensor, LetsItsProgramGoOnWhileTheCameraIsAway) {
  const auto sensor = load("camera = FAKE", "trouble = hangs\ngood_frames = 1\n");
  sensor->initialize();
  EXPECT_THAT(grab(*sensor), SizeIs(1));
  sensor->doProcess();
  EXPECT_THAT(sensor->getObservations(), IsEmpty());
  EXPECT_THAT(grab(*sensor), SizeIs(1));  // opened again
}

TEST_F(SemanticSensor, SaysWhatIsWrong) {
  const auto complaint = [](const CGenericSensor::Ptr& sensor) {
    return test::complaintOf([&] {
      sensor->initialize();
      return 0;
    });
  };
  const std::string mustName = "[CAMERA]: the key 'camera' must name the section of the camera";
  EXPECT_EQ(complaint(load("")), mustName);
  EXPECT_EQ(complaint(load("camera = CAMERA")), mustName);
  EXPECT_EQ(complaint(load("camera = FAK")), "the configuration: has no sensor [FAK]; did you mean [FAKE]?");
  EXPECT_THAT(complaint(load("camera = FAKE\nmode = propagate", "", "segmentation.type = none\n")),
              HasSubstr("but nothing segments"));
  EXPECT_EQ(complaint(load("camera = FAKE", "only_while = /no/such/file\n")),
            "the configuration: [FAKE]: no fake camera found");
  EXPECT_THAT(complaint(CGenericSensor::createSensorPtr("CSemanticRGBDSensor")), HasSubstr("load a configuration"));
}

}  // namespace
}  // namespace wardslam::mrpt_sensor
