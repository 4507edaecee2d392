#include <gtest/gtest.h>
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/system/os.h>

#include <string>

namespace wardslam::mrpt_sensor {
namespace {

TEST(RegisterSensor, LoadedAsAPluginOfMrptAllClassesAreKnown) {
  std::string trouble;
  ASSERT_TRUE(mrpt::system::loadPluginModule(WARDSLAM_MRPT_PLUGIN, trouble)) << trouble;
  EXPECT_NE(mrpt::hwdrivers::CGenericSensor::createSensorPtr("CSemanticRGBDSensor"), nullptr);
  for (const std::string name : {"wardslam::mrpt_plugin::CObservationSemanticRGBD",
                                 "wardslam::mrpt_plugin::CSemanticMap", "wardslam::filters::SemanticDynamicFilter"}) {
    EXPECT_NE(mrpt::rtti::findRegisteredClass(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace wardslam::mrpt_sensor
