#include "wardslam/mrpt_plugin/register_all.h"

#include <gtest/gtest.h>
#include <mrpt/rtti/CObject.h>

#include <string>

namespace wardslam::mrpt_plugin {
namespace {

bool canCreate(const std::string& className) {
  const auto* type = mrpt::rtti::findRegisteredClass(className);
  return type != nullptr && type->ptrCreateObject && type->ptrCreateObject() != nullptr;
}

TEST(RegisterAll, MakesFiltersByName) {
  registerAll();
  EXPECT_TRUE(canCreate("wardslam::filters::SemanticDynamicFilter"));
  EXPECT_TRUE(canCreate("wardslam::filters::GeometricMotionFilter"));
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
