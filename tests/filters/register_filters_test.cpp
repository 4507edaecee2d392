#include "wardslam/filters/register_filters.h"

#include <gmock/gmock.h>

#include <cctype>
#include <fstream>
#include <string>
#include <vector>

#include "filters/ward_fixture.h"
#include "wardslam/filters/filter_chain.h"

namespace wardslam::filters {
namespace {

const std::string kNamespace = "wardslam::filters::";

std::vector<std::string> ownFilters() {
  registerAllFilters();
  std::vector<std::string> names;
  for (const auto* type : mrpt::rtti::getAllRegisteredClassesChildrenOf(CLASS_ID(ObservationFilter))) {
    const std::string name = type->className;
    if (type->ptrCreateObject && name.rfind(kNamespace, 0) == 0) names.push_back(name.substr(kNamespace.size()));
  }
  return names;
}

/// SomeFilter -> .../some_filter.h
std::string headerOf(const std::string& filter) {
  std::string file;
  for (const char c : filter) {
    const bool isUpper = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (isUpper && !file.empty()) file += '_';
    file += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return std::string(WARDSLAM_FILTERS_DIR) + "/" + file + ".h";
}

/// The lines of the doc comment from "filters:" to the next that is empty.
std::string exampleIn(const std::string& header) {
  constexpr const char* kComment = "///     ";
  std::ifstream file(header);
  std::string example;
  for (std::string line; std::getline(file, line);) {
    const bool isPart = line.rfind(kComment, 0) == 0;
    if (!isPart && !example.empty()) break;
    const std::string text = isPart ? line.substr(std::string(kComment).size()) : "";
    if (!example.empty() || text == "filters:") example += text + "\n";
  }
  return example;
}

std::string chainOf(const std::string& configuration) {
  const auto list = core::ConfigNode::fromText(configuration).child("filters");
  return FilterChain(list, ward::context(std::make_shared<segmentation::Segmenter::Result>())).parameters(1);
}

TEST(RegisterFilters, KnowsTheFiltersOfThisRoom) {
  EXPECT_THAT(ownFilters(), testing::UnorderedElementsAre("SemanticDynamicFilter", "GeometricMotionFilter"));
}

TEST(RegisterFilters, EveryFilterHasAnExampleOfAllItsParametersAsTheyAreByDefault) {
  for (const std::string& filter : ownFilters()) {
    const std::string example = exampleIn(headerOf(filter));
    ASSERT_THAT(example, testing::HasSubstr("class_name: " + kNamespace + filter + "\n")) << headerOf(filter);
    const std::string defaults = chainOf("filters: [{class_name: '" + kNamespace + filter + "'}]");
    EXPECT_EQ(chainOf(example), defaults);
    EXPECT_EQ(YAML::Load(example)["filters"][0]["params"].size(), YAML::Load(defaults)[0]["params"].size())
        << "parameters of " << filter;
  }
}

}  // namespace
}  // namespace wardslam::filters
