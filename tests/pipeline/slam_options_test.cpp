#include "wardslam/pipeline/slam_options.h"

#include <gmock/gmock.h>

#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/filters/filter_chain.h"

namespace wardslam::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SlamOptionsTest : public ::testing::Test {
 protected:
  [[nodiscard]] SlamOptions read(const std::string& yaml) const {
    return readSlamOptions(folder_.write("my.yaml", yaml));
  }

  /// What reading complains about; empty when it does not.
  [[nodiscard]] std::string complaint(const std::string& yaml) const {
    return test::complaintOf([&] { return read(yaml); });
  }

  test::TemporaryFolder folder_;
};

TEST_F(SlamOptionsTest, AFileOverlaysTheDefaults) {
  const SlamOptions defaults;
  const auto options = read(
      "features: {key_points: 500}\n"
      "odometry:\n"
      "  matcher: {max_ratio: 0.8}\n"
      "segmentation: {type: recorded_masks, recorded_masks: {folder: there}}\n");
  EXPECT_EQ(options.features.key_points, 500);
  EXPECT_EQ(options.odometry.matcher.max_ratio, 0.8);
  EXPECT_EQ(options.segmentation.type, segmentation::SegmentationOptions::Type::RecordedMasks);
  EXPECT_EQ(options.segmentation.recorded_masks.folder, "there");
  EXPECT_EQ(options.file, folder_.path() / "my.yaml");

  EXPECT_EQ(options.features.levels, defaults.features.levels);
  EXPECT_EQ(options.odometry.matcher.wide_radius_px, defaults.odometry.matcher.wide_radius_px);
  EXPECT_EQ(options.odometry.min_inliers, defaults.odometry.min_inliers);
  EXPECT_EQ(options.knowledge.file, defaults.knowledge.file);
  ASSERT_EQ(options.filters.yaml().size(), 2U);
  EXPECT_EQ(options.filters.yaml()[0]["class_name"].as<std::string>(), "wardslam::filters::SemanticDynamicFilter");
  EXPECT_EQ(options.filters.yaml()[1]["class_name"].as<std::string>(), "wardslam::filters::GeometricMotionFilter");
}

TEST_F(SlamOptionsTest, AnEmptyFileKeepsThemAll) {
  EXPECT_EQ(writeSlamOptions(read(""), {}), writeSlamOptions({}, {}));
}

TEST_F(SlamOptionsTest, FiltersAreReplacedAsAWhole) {
  const auto two = read("filters:\n  - {class_name: first}\n  - {class_name: second, params: {a: 1}}\n");
  ASSERT_EQ(two.filters.yaml().size(), 2U);
  EXPECT_EQ(two.filters.item(1).child("class_name").yaml().as<std::string>(), "second");
  EXPECT_EQ(read("filters: []\n").filters.yaml().size(), 0U);
}

TEST_F(SlamOptionsTest, AParameterOfAFilterCanBeOverruled) {
  auto options = read("filters:\n  - {class_name: first}\n  - {class_name: second, params: {a: 1, b: 2}}\n");
  EXPECT_TRUE(options.setFilterParameter("second", "a", "7"));
  EXPECT_TRUE(options.setFilterParameter("first", "c", "word"));
  EXPECT_FALSE(options.setFilterParameter("third", "a", "7"));
  const auto parameter = [&](std::size_t filter, const char* key) {
    return options.filters.item(filter).child("params").child(key).yaml().as<std::string>();
  };
  EXPECT_EQ(parameter(1, "a"), "7");
  EXPECT_EQ(parameter(1, "b"), "2");
  EXPECT_EQ(parameter(0, "c"), "word");

  SlamOptions defaults;
  EXPECT_TRUE(defaults.setFilterParameter("wardslam::filters::SemanticDynamicFilter", "n", "5"));
  EXPECT_FALSE(SlamOptions{}.filters.item(0).child("params").exists()) << "other options stay as they are";
  defaults.filters = SlamOptions::noFilters();
  EXPECT_FALSE(defaults.setFilterParameter("wardslam::filters::SemanticDynamicFilter", "n", "5"));
}

TEST_F(SlamOptionsTest, AllFiltersButThoseOfOneClassCanBeLeftOut) {
  auto options = read("filters:\n  - {class_name: first}\n  - {class_name: second, params: {a: 1}}\n");
  options.keepOnlyFilters("second");
  ASSERT_EQ(options.filters.yaml().size(), 1U);
  EXPECT_EQ(options.filters.item(0).child("params").child("a").yaml().as<int>(), 1);

  options.keepOnlyFilters("third");
  ASSERT_EQ(options.filters.yaml().size(), 1U);
  EXPECT_EQ(options.filters.item(0).child("class_name").yaml().as<std::string>(), "third");
  EXPECT_FALSE(options.filters.item(0).child("params").exists());

  auto wrong = read("filters: {class_name: first}\n");
  wrong.keepOnlyFilters("first");
  EXPECT_THROW(filters::FilterChain(wrong.filters, {}), core::InputError) << "still no list";
}

TEST_F(SlamOptionsTest, FiltersOfOneClassCanBeLeftOut) {
  auto options = read("filters:\n  - {class_name: first}\n  - {class_name: second, params: {a: 1}}\n");
  options.removeFilters("first");
  ASSERT_EQ(options.filters.yaml().size(), 1U);
  EXPECT_EQ(options.filters.item(0).child("params").child("a").yaml().as<int>(), 1);
  options.removeFilters("second");
  EXPECT_TRUE(filters::FilterChain(options.filters, {}).empty());
}

TEST_F(SlamOptionsTest, SegmentsByDefaultWhereAFilterWantsIt) {
  const std::string geometric = "filters: [{class_name: 'wardslam::filters::GeometricMotionFilter'}]\n";
  EXPECT_TRUE(SlamOptions{}.segments());
  EXPECT_TRUE(read("features: {key_points: 700}\n").segments());
  EXPECT_FALSE(read("segmentation: {type: none}\n").segments());
  EXPECT_FALSE(read("filters: []\n").segments());
  EXPECT_FALSE(read(geometric).segments());
  EXPECT_TRUE(read("segmentation: {type: yolo}\n" + geometric).segments()) << "who says so gets it";
}

TEST_F(SlamOptionsTest, AnUnknownKeyNamesTheNearest) {
  EXPECT_THAT(complaint("features:\n  keypoints: 500\n"),
              HasSubstr("my.yaml:2: 'features.keypoints': unknown key; did you mean 'key_points'?"));
  EXPECT_THAT(complaint("\nodometri: {}\n"), HasSubstr("my.yaml:2: 'odometri': unknown key; did you mean 'odometry'?"));
  EXPECT_THAT(complaint("filter: []\n"), HasSubstr("did you mean 'filters'?"));
}

TEST_F(SlamOptionsTest, BadValuesAndFilesAreRefused) {
  EXPECT_THAT(complaint("features: {key_points: 10}\n"), HasSubstr("my.yaml:1: 'features.key_points'"));
  EXPECT_THAT(complaint("features: {levels: many}\n"), HasSubstr("'features.levels'"));
  EXPECT_THAT(complaint("segmentation: {type: magic}\n"), HasSubstr("recorded_masks"));
  EXPECT_THAT(complaint("features: [1, 2]\n"), HasSubstr("my.yaml:1: 'features'"));
  EXPECT_THAT(complaint("features: {key_points: 500\n"), HasSubstr("my.yaml:2: not valid YAML"));
  EXPECT_THROW(static_cast<void>(readSlamOptions(folder_.path() / "none.yaml")), core::InputError);
}

TEST_F(SlamOptionsTest, WhatIsWrittenReadsBackTheSame) {
  auto options = read("features: {scale_factor: 1.3}\nsegmentation: {type: yolo, yolo: {model: \"a # b.onnx\"}}\n");
  options.filters = SlamOptions::noFilters();
  const std::string text = writeSlamOptions(options, {});
  const auto again = read(text);
  EXPECT_EQ(writeSlamOptions(again, {}), text);
  EXPECT_EQ(again.features.scale_factor, 1.3);
  EXPECT_EQ(again.segmentation.yolo.model, "a # b.onnx");
  EXPECT_EQ(again.filters.yaml().size(), 0U) << "no filter was written: none is read";
}

TEST_F(SlamOptionsTest, AKnowledgeFileBesideItIsNamedInFull) {
  const auto beside = folder_.write("mine.yaml", "");
  EXPECT_EQ(read("knowledge: {file: mine.yaml}\n").knowledge.file, beside.string());
  EXPECT_EQ(read("knowledge: {file: knowledge/hospital.yaml}\n").knowledge.file, "knowledge/hospital.yaml")
      << "it comes with the program";
  EXPECT_EQ(read("knowledge: {file: " + beside.string() + "}\n").knowledge.file, beside.string());
}

TEST(WithoutFolders, LeavesTheNamesOfFiles) {
  const std::string yaml =
      "deterministic: true  # same input: same bytes / out\n"
      "segmentation:\n"
      "  masks: \"/home/somebody/ward 3/masks\"  # folder\n"
      "  model: '/networks/yolo.onnx'\n"
      "  depth: /data/net.onnx\n"
      "knowledge:\n"
      "  file: \"knowledge/hospital.yaml\"\n";
  EXPECT_EQ(withoutFolders(yaml),
            "deterministic: true  # same input: same bytes / out\n"
            "segmentation:\n"
            "  masks: \"masks\"  # folder\n"
            "  model: 'yolo.onnx'\n"
            "  depth: net.onnx\n"
            "knowledge:\n"
            "  file: \"knowledge/hospital.yaml\"\n");
}

}  // namespace
}  // namespace wardslam::pipeline
