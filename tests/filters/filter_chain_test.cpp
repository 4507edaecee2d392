#include "wardslam/filters/filter_chain.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "filters/ward_fixture.h"
#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/filters/register_filters.h"

namespace wardslam::filters {
namespace {

using testing::HasSubstr;

const std::string kPlugin = WARDSLAM_TEST_PLUGIN;

core::ConfigNode listOf(const std::string& text, const std::filesystem::path& file = "wardslam.yaml") {
  return core::ConfigNode::fromText("filters:\n" + text, file).child("filters");
}

FilterContext wardContext() { return ward::context(std::make_shared<segmentation::Segmenter::Result>()); }

std::string errorOf(const std::string& text, const FilterContext& context = wardContext()) {
  return wardslam::test::complaintOf([&] { FilterChain(listOf(text), context); });
}

core::Frame frameWithKeypoints(std::size_t count) {
  core::Frame frame;
  frame.features.keypoints.resize(count);
  return frame;
}

TEST(FilterChain, WithoutAListNothingIsFiltered) {
  core::Frame frame = frameWithKeypoints(3);
  FilterChain chain(listOf(""), {});
  chain.begin(frame);
  chain.apply(frame);
  EXPECT_TRUE(chain.empty());
  EXPECT_EQ(chain.parameters(0), "");
  for (const auto& keypoint : frame.features.keypoints) EXPECT_EQ(keypoint.motion, core::Motion::Static);
}

TEST(FilterChain, MakesFiltersByClassName) {
  const FilterChain chain(listOf(" - class_name: wardslam::filters::SemanticDynamicFilter\n"
                                 "   params: {n: 5, delta: 3}\n"),
                          wardContext());
  ASSERT_EQ(chain.size(), 1U);
  EXPECT_THAT(chain.parameters(0), HasSubstr("n: 5 "));
}

TEST(FilterChain, AFilterOfAPluginTakesPart) {
  FilterChain chain(listOf(" - class_name: third_party::EveryNthFilter\n"
                           "   plugin: " +
                           kPlugin + "\n   params: {nth: 3}\n"),
                    {});
  core::Frame frame = frameWithKeypoints(7);
  chain.begin(frame);
  chain.apply(frame);
  for (std::size_t i = 0; i < 7; ++i) {
    const auto expected = i % 3 == 0 ? core::Motion::Dynamic : core::Motion::Static;
    EXPECT_EQ(frame.features.keypoints[i].motion, expected) << i;
  }
  EXPECT_TRUE(frame.events.empty()) << "begin() reached the filter";
}

TEST(FilterChain, FiltersWorkOneAfterTheOther) {
  const std::string plugin = "   plugin: " + kPlugin + "\n";
  FilterChain chain(listOf(" - class_name: third_party::EveryNthFilter\n" + plugin + "   params: {nth: 4}\n" +
                           " - class_name: third_party::EveryNthFilter\n" + plugin + "   params: {nth: 5}\n"),
                    {});
  core::Frame frame = frameWithKeypoints(6);
  chain.begin(frame);
  chain.apply(frame);
  std::vector<std::size_t> dynamic;
  for (std::size_t i = 0; i < 6; ++i) {
    if (frame.features.keypoints[i].motion == core::Motion::Dynamic) dynamic.push_back(i);
  }
  EXPECT_THAT(dynamic, testing::ElementsAre(0, 4, 5));
}

TEST(FilterChain, ARelativePluginPathStartsAtTheConfiguration) {
  const std::filesystem::path plugin = kPlugin;
  const std::string text = " - {class_name: 'third_party::IdleFilter', plugin: " + plugin.filename().string() + "}\n";
  EXPECT_EQ(FilterChain(listOf(text, plugin.parent_path() / "wardslam.yaml"), {}).size(), 1U);
  EXPECT_THROW(FilterChain(listOf(text, "/nowhere/wardslam.yaml"), {}), core::InputError);
}

TEST(FilterChain, WritesTheListItCanBeReadFrom) {
  const FilterChain chain(
      listOf(" - class_name: third_party::EveryNthFilter\n   plugin: " + kPlugin + "\n" +
             " - class_name: wardslam::filters::SemanticDynamicFilter\n   params: {margin_px: 1}\n" +
             " - class_name: third_party::IdleFilter\n"),
      wardContext());
  const std::string written = chain.parameters(1);
  EXPECT_EQ(written.rfind("  - class_name: third_party::EveryNthFilter\n", 0), 0U) << written;

  const FilterChain again(listOf(written), wardContext());
  EXPECT_EQ(again.parameters(1), written);

  const YAML::Node list = YAML::Load(written);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0]["params"]["nth"].as<int>(), 2) << "defaults are written, too";
  EXPECT_EQ(list[1]["params"]["margin_px"].as<int>(), 1);
  EXPECT_EQ(list[1]["params"]["delta"].as<int>(), 55);
  EXPECT_EQ(list[2]["params"].size(), 0U);
}

TEST(FilterChain, RegisteringTwiceDoesNoHarm) {
  registerAllFilters();
  registerAllFilters();
  EXPECT_NE(mrpt::rtti::classFactory("wardslam::filters::SemanticDynamicFilter"), nullptr);
}

TEST(FilterChain, SaysWhatIsWrongWithTheList) {
  EXPECT_THAT(errorOf(" - class_name: wardslam::filters::SemanticDynamikFilter\n"),
              testing::AllOf(HasSubstr("wardslam.yaml:2"), HasSubstr("'filters[0].class_name'"),
                             HasSubstr("did you mean 'wardslam::filters::SemanticDynamicFilter'")));
  EXPECT_THAT(errorOf(" - class_name: mrpt::obs::CObservationImage\n"), HasSubstr("CObservationImage'"));
  EXPECT_THAT(errorOf(" - class_name: wardslam::filters::ObservationFilter\n"), HasSubstr("is no observation filter"));
  EXPECT_THAT(errorOf(" - {clas_name: x}\n"),
              testing::AllOf(HasSubstr("wardslam.yaml:2"), HasSubstr("did you mean 'class_name'")));
  EXPECT_THAT(errorOf(" - {params: {n: 5}}\n"), testing::AllOf(HasSubstr("class_name"), HasSubstr("a text")));
  EXPECT_THAT(errorOf(" - SemanticDynamicFilter\n"), HasSubstr("a mapping"));
  EXPECT_THAT(errorOf(" {class_name: x}\n"), HasSubstr("a list of filters"));
}

TEST(FilterChain, SaysWhatIsWrongWithAPlugin) {
  EXPECT_THAT(errorOf(" - {class_name: x, plugin: /nowhere/libx.so}\n"),
              testing::AllOf(HasSubstr("wardslam.yaml:2"), HasSubstr("there is no plug-in /nowhere/libx.so")));
  const test::TemporaryFolder folder;
  const std::string noLibrary = folder.write("libnone.so", "no library");
  EXPECT_THAT(errorOf(" - {class_name: x, plugin: " + noLibrary + "}\n"),
              testing::AllOf(HasSubstr("wardslam.yaml:2"), HasSubstr("cannot be loaded")));
}

TEST(FilterChain, SaysWhatIsWrongWithParameters) {
  const std::string filter = " - class_name: wardslam::filters::SemanticDynamicFilter\n   params: ";
  EXPECT_THAT(errorOf(filter + "{dleta: 3}\n"),
              testing::AllOf(HasSubstr("wardslam.yaml:3"), HasSubstr("'filters[0].params.dleta'"),
                             HasSubstr("did you mean 'delta'")));
  EXPECT_THAT(errorOf(filter + "{n: 20}\n"), HasSubstr("20 is even"));
  EXPECT_THAT(errorOf(filter + "{n: -3}\n"), HasSubstr("outside"));
  EXPECT_THAT(errorOf(filter + "{n: 5, delta: 25}\n"), HasSubstr("can never be exceeded by the 25 pixels"));
  EXPECT_EQ(errorOf(filter + "{n: 5, delta: 24}\n"), "");
}

TEST(FilterChain, SaysWhatAFilterLacks) {
  const std::string filter = " - class_name: wardslam::filters::SemanticDynamicFilter\n";
  FilterContext context = wardContext();
  context.segmenter = nullptr;
  EXPECT_THAT(errorOf(filter, context), HasSubstr("needs a segmenter"));
  context = wardContext();
  context.knowledge = nullptr;
  EXPECT_THAT(errorOf(filter, context), HasSubstr("needs a knowledge graph"));
}

}  // namespace
}  // namespace wardslam::filters
