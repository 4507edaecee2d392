#include "wardslam/segmentation/label_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

using core::ClassId;
using core::InputError;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class LabelMapTest : public ::testing::Test {
 protected:
  LabelMap read(const std::string& text, int firstId = 1) const {
    return LabelMap::fromFile(folder_.write("net.yaml", text), firstId);
  }
  void expectRefused(const std::string& text, const std::string& part, const std::string& other = {}) const {
    EXPECT_THAT([&] { (void)read(text); }, ThrowsMessage<InputError>(AllOf(HasSubstr(part), HasSubstr(other)))) << text;
  }

  test::TemporaryFolder folder_;
};

TEST_F(LabelMapTest, CountsOnWithoutAFile) {
  const auto map = LabelMap::consecutive(core::LabelSpace::coco());
  EXPECT_EQ(map.classOf(0), 1);
  EXPECT_EQ(map.classOf(254), 255);
  EXPECT_EQ(map.classOf(255), 0);
  EXPECT_EQ(map.classOf(-1), 0);
  EXPECT_EQ(LabelMap::consecutive(core::LabelSpace::coco(), 0).classOf(57), 57);
}

TEST_F(LabelMapTest, ListsMeaningsByIndex) {
  const auto map = read("names: {100: trolley, 101: IV stand}\nclasses: [~, person, trolley, 101, chair, person]\n");
  const std::vector<ClassId> expected = {0, 1, 100, 101, 57, 1, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(map.classOf(static_cast<int>(i)), expected[i]) << i;
  EXPECT_EQ(map.labels().name(101), "IV stand");
  EXPECT_EQ(map.labels().name(57), "chair");
}

TEST_F(LabelMapTest, MapsMeaningsByIndex) {
  const auto map = read("classes: {1203: bed, 7: person, 8: ~}\n");
  EXPECT_EQ(map.classOf(7), 1);
  EXPECT_EQ(map.classOf(8), 0);
  EXPECT_EQ(map.classOf(0), 0);
  EXPECT_EQ(map.classOf(1203), 60);
  EXPECT_EQ(map.classOf(1204), 0);
}

TEST_F(LabelMapTest, NamesAloneLeaveTheCounting) {
  const auto map = read("names: {2: stretcher}\n");
  EXPECT_EQ(map.classOf(1), 2);
  EXPECT_EQ(map.labels().name(2), "stretcher");
  EXPECT_EQ(map.labels().find("bicycle"), std::nullopt);
  EXPECT_EQ(read("names: {2: stretcher}\n", 0).classOf(1), 1);
}

TEST_F(LabelMapTest, MayMoveACocoName) {
  const auto map = read("names: {100: person, 1: robot}\nclasses: [person, robot]\n");
  EXPECT_EQ(map.classOf(0), 100);
  EXPECT_EQ(map.classOf(1), 1);
}

TEST_F(LabelMapTest, ExtendsAnotherFile) {
  folder_.write("base.yaml", "names: {100: trolley, 101: curtain}\nclasses: [person]\n");
  const auto map = read("extends: base.yaml\nnames: {101: screen}\nclasses: [trolley, screen]\n");
  EXPECT_EQ(map.classOf(0), 100);
  EXPECT_EQ(map.classOf(1), 101);
  EXPECT_EQ(map.labels().find("curtain"), std::nullopt);
  // Shipped files are found from anywhere.
  EXPECT_EQ(read("extends: labels/hospital.yaml\nclasses: [wheelchair]\n").labels().find("wheelchair"), ClassId{105});
}

TEST_F(LabelMapTest, ReadsLinesOfIdsAndNames) {
  const auto map = LabelMap::fromFile(folder_.write("classes.txt", "102 trolley\n"));
  EXPECT_EQ(map.labels().name(102), "trolley");
  EXPECT_EQ(map.classOf(101), 102);
}

TEST_F(LabelMapTest, NamesMistakesByFileLineAndKey) {
  expectRefused("classes: [person,\n  troley]\nnames: {100: trolley}\n", "net.yaml:2: 'classes[1]'",
                "did you mean 'trolley'");
  expectRefused("classes: {0: person,\n  1: [a]}\n", "net.yaml:2: 'classes.1'", "a name, an id or ~");
  expectRefused("classes: {first: person}\n", "net.yaml:1: 'classes'", "a number is expected as key");
  expectRefused("classes: {-1: person}\n", "0 to 65535");
  expectRefused("classes: {0: person, 0: chair}\n", "'classes.0'", "given twice");
  expectRefused("classes: [256]\n", "'classes[0]'", "0 to 255");
  expectRefused("classes: person\n", "'classes'", "a list");
  expectRefused("names: {0: nothing}\n", "'names'", "1 to 255");
  expectRefused("names: {100: }\n", "'names.100'", "a name is expected");
  expectRefused("names: {100: trolley, 101: trolley}\n", "'names.101'", "the name of class 100 already");
  expectRefused("names: {100: trolley, 100: bin}\n", "'names.100'", "named twice");
  expectRefused("names: [trolley]\n", "'names'", "a mapping");
  expectRefused("clases: [person]\n", "'clases'", "did you mean 'classes'");
  expectRefused("extends: missing.yaml\n", "missing.yaml: not found");
  expectRefused("extends: net.yaml\n", "'extends'", "in a circle");
  EXPECT_THAT([] { (void)LabelMap::fromFile("labels/nowhere.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("labels/nowhere.yaml")));
}

TEST_F(LabelMapTest, KnowsTheUsualNetworksByTheirNumberOfClasses) {
  EXPECT_EQ(LabelMap::forNetwork(80, {}, "net").classOf(79), 80);
  EXPECT_EQ(LabelMap::forNetwork(90, {}, "net").classOf(89), 80);
  EXPECT_EQ(LabelMap::forNetwork(21, {}, "net").classOf(15), 1);
  EXPECT_EQ(LabelMap::forNetwork(150, {}, "net").classOf(12), 1);
  EXPECT_THAT([] { (void)LabelMap::forNetwork(5, {}, "net.onnx"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("net.onnx: knows 5 classes"), HasSubstr("label file"))));
}

TEST_F(LabelMapTest, TakesTheNamesThatANetworkBrings) {
  const auto map =
      LabelMap::forNetwork(4, {}, "net", {"chair", "Wheelchair", "iv stand", "drip bag"}, LabelMap::Family::Yolo);
  EXPECT_EQ(map.classOf(0), 57);
  EXPECT_EQ(map.classOf(1), 105);
  EXPECT_EQ(map.labels().name(105), "wheelchair");
  EXPECT_EQ(map.classOf(2), 103);
  EXPECT_GE(map.classOf(3), 150);
  EXPECT_EQ(map.labels().name(map.classOf(3)), "drip bag");
  EXPECT_EQ(map.labels().find("curtain"), std::nullopt);
  EXPECT_THAT([] { (void)LabelMap::forNetwork(3, {}, "net", {"person"}); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("knows 3 classes"), HasSubstr("names 1"))));
}

TEST_F(LabelMapTest, YoloNetworksAreNotTakenForPascalVoc) {
  for (const int classes : {21, 90, 150}) {
    EXPECT_THAT([&] { (void)LabelMap::forNetwork(classes, {}, "net", {}, LabelMap::Family::Yolo); },
                ThrowsMessage<InputError>(HasSubstr("--classes")))
        << classes;
  }
  EXPECT_EQ(LabelMap::forNetwork(80, {}, "net", {}, LabelMap::Family::Yolo).classOf(0), 1);
}

TEST_F(LabelMapTest, ExtendsTheFilesThatComeWithTheProgramFromAnywhere) {
  const auto map =
      LabelMap::fromFile(folder_.write("two.yaml", "extends: hospital.yaml\nclasses: [person, wheelchair]\n"));
  EXPECT_EQ(map.classOf(1), 105);
}

TEST_F(LabelMapTest, RefusesAFileForAnotherNetwork) {
  const auto list = folder_.write("list.yaml", "classes: [person, chair]\n");
  EXPECT_EQ(LabelMap::forNetwork(2, list, "net").classOf(1), 57);
  EXPECT_THAT([&] { (void)LabelMap::forNetwork(3, list, "net"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("net: knows 3 classes"), HasSubstr("lists 2"))));
  const auto mapping = folder_.write("mapping.yaml", "classes: {4: person}\n");
  EXPECT_EQ(LabelMap::forNetwork(5, mapping, "net").classOf(4), 1);
  EXPECT_THAT([&] { (void)LabelMap::forNetwork(4, mapping, "net"); },
              ThrowsMessage<InputError>(HasSubstr("gives class 4 a meaning")));
}

TEST_F(LabelMapTest, TranslatesWholePictures) {
  const auto map = read("classes: {0: person, 3: bed, 300: chair}\n");
  const cv::Mat numbers = (cv::Mat_<float>(2, 3) << 0, 3, 300, -1, 1e9F, 2);
  const cv::Mat expected = (cv::Mat_<ClassId>(2, 3) << 1, 60, 57, 0, 0, 0);
  EXPECT_EQ(cv::norm(map.apply(numbers), expected, cv::NORM_INF), 0.0);
  const cv::Mat bytes = (cv::Mat_<ClassId>(1, 3) << 0, 3, 255);
  const cv::Mat expectedOfBytes = (cv::Mat_<ClassId>(1, 3) << 1, 60, 0);
  EXPECT_EQ(cv::norm(map.apply(bytes), expectedOfBytes, cv::NORM_INF), 0.0);
}

// COCO never used ten of its ninety category ids; networks of 80 classes count the others on.
TEST(ShippedLabels, Coco90CountsOnWithoutTheGaps) {
  const std::set<int> unusedCategories = {12, 26, 29, 30, 45, 66, 68, 69, 71, 83};
  const auto map = LabelMap::fromFile("labels/coco90.yaml");
  int used = 0;
  for (int category = 1; category <= 90; ++category) {
    const int expected = unusedCategories.count(category) > 0 ? 0 : ++used;
    EXPECT_EQ(map.classOf(category - 1), expected) << category;
  }
  EXPECT_EQ(used, 80);
  EXPECT_EQ(map.classOf(90), 0);
}

TEST(ShippedLabels, CanAllBeRead) {
  int count = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(core::findDataFile("labels/hospital.yaml").parent_path())) {
    EXPECT_NO_THROW((void)LabelMap::fromFile(file.path())) << file;
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(ShippedLabels, VocHasTwentyClassesAndABackground) {
  const auto map = LabelMap::fromFile("labels/voc21.yaml");
  std::set<int> ids;
  for (int i = 1; i <= 20; ++i) ids.insert(map.classOf(i));
  EXPECT_EQ(ids.size(), 20U);
  EXPECT_EQ(ids.count(0), 0U);
  EXPECT_EQ(map.classOf(0), 0);
  EXPECT_EQ(map.labels().name(map.classOf(9)), "chair");
}

}  // namespace
}  // namespace wardslam::segmentation
