#include "wardslam/mrpt_plugin/observation_annotator.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/containers/yaml.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"
#include "support/textured_room_scan.h"
#include "wardslam/core/annotation.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::mrpt_plugin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::ThrowsMessage;

/// Made by name, as in a program that knows the library only by its file.
std::shared_ptr<ObservationAnnotator> makeByName() {
  registerAll();
  return std::dynamic_pointer_cast<ObservationAnnotator>(
      mrpt::rtti::classFactory("wardslam::mrpt_plugin::ObservationAnnotator"));
}

class Annotator : public ::testing::Test {
 protected:
  /// The left quarter of the image is a person.
  Annotator() {
    cv::Mat mask(240, 320, CV_8UC1, cv::Scalar(0));
    mask.colRange(0, 80).setTo(1);
    if (!cv::imwrite((folder.path() / "1000.000000.png").string(), mask)) throw std::runtime_error("no mask written");
  }

  void expectAnnotates(ObservationAnnotator& annotator) const {
    const auto scan = test::observe(room, 0);
    EXPECT_TRUE(annotator.doFilter(scan));
    const cv::Mat bits = core::annotationOf(*scan);
    ASSERT_EQ(bits.size(), cv::Size(320, 240));
    EXPECT_NE(bits.at<std::uint8_t>(100, 20) & core::bitOf(core::PixelLabel::Dynamic), 0);
    EXPECT_EQ(bits.at<std::uint8_t>(100, 200), 0);
    ASSERT_TRUE(annotator.found());
    EXPECT_EQ(annotator.found()->timestamp, scan->timestamp);
  }

  test::TexturedRoom room;
  test::TemporaryFolder folder;
};

TEST_F(Annotator, IsConfiguredByYaml) {
  const auto annotator = makeByName();
  ASSERT_TRUE(annotator);
  annotator->initialize(mrpt::containers::yaml::FromText(
      "segmentation: {type: recorded_masks, recorded_masks: {folder: '" + folder.path().string() + "'}}\n" +
      "filters:\n  - class_name: 'wardslam::filters::SemanticDynamicFilter'\n    params: {margin_px: 5}\n"));
  expectAnnotates(*annotator);
}

TEST_F(Annotator, IsConfiguredByAnIniFile) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent("[WardSLAM]\nsegmentation.type = recorded_masks\nsegmentation.recorded_masks.folder = " +
                 folder.path().string() + "\n");
  const auto annotator = makeByName();
  annotator->loadConfig(ini, "WardSLAM");
  expectAnnotates(*annotator);
}

TEST_F(Annotator, LetsOthersPassAndCountsWhatCannotBeUsed) {
  const auto annotator = makeByName();
  annotator->initialize(
      mrpt::containers::yaml::FromText("filters: [{class_name: 'wardslam::filters::GeometricMotionFilter'}]"));
  EXPECT_FALSE(annotator->doFilter(std::make_shared<mrpt::obs::CObservationOdometry>()));
  const auto scan = test::observe(room, 0);
  scan->cameraParams.ncols = 7;
  EXPECT_FALSE(annotator->doFilter(scan));
  EXPECT_THAT(annotator->events(), ElementsAre(Pair("sources.observation_unusable", 1)));
  EXPECT_FALSE(annotator->found());
}

TEST_F(Annotator, NamesWrongKeys) {
  EXPECT_THAT([] { makeByName()->initialize(mrpt::containers::yaml::FromText("segmentatoin: {type: none}")); },
              ThrowsMessage<core::InputError>(HasSubstr("segmentation")));
}

TEST_F(Annotator, MustBeConfiguredFirst) {
  EXPECT_THROW(makeByName()->doFilter(test::observe(room, 0)), std::logic_error);
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
