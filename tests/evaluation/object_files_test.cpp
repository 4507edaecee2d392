#include "wardslam/evaluation/object_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::evaluation {
namespace {

using testing::HasSubstr;

constexpr const char* kHeader = "name,class_id,class_name,xmin,ymin,zmin,xmax,ymax,zmax,frames_visible,max_pixels\n";

TEST(ObjectFilesTest, ReadsTrueObjects) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("objects.csv", std::string(kHeader) + "bed_1,60,bed,-1,-2,0,1,2,0.5,30,1600\r\n\n");
  const auto objects = readTrueObjects(file);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].name, "bed_1");
  EXPECT_EQ(objects[0].classId, 60);
  EXPECT_EQ(objects[0].className, "bed");
  EXPECT_EQ(objects[0].box_m.min(), Eigen::Vector3d(-1, -2, 0));
  EXPECT_EQ(objects[0].box_m.max(), Eigen::Vector3d(1, 2, 0.5));
  EXPECT_EQ(objects[0].framesVisible, 30);
  EXPECT_EQ(objects[0].maxPixels, 1600);
}

TEST(ObjectFilesTest, CountsHowWellThingsWereSeenWhereNoColumnTells) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("objects.csv",
                                 "instance_id,name,class_id,class_name,xmin,ymin,zmin,xmax,ymax,zmax\n"
                                 "7,bed_1,60,bed,-1,-2,0,1,2,0.5\n9,bed_2,60,bed,5,5,0,6,6,0.5\n");
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(file); }), HasSubstr("instances is not there"));
  std::filesystem::create_directory(folder.path() / "instances");
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(file); }), HasSubstr("instances: holds no image"));
  cv::Mat ids = cv::Mat::zeros(4, 5, CV_16UC1);
  ids.row(0) = 7;
  cv::imwrite((folder.path() / "instances/1.0.png").string(), ids);
  ids.row(1) = 7;
  cv::imwrite((folder.path() / "instances/2.0.png").string(), ids);
  const auto objects = readTrueObjects(file);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].framesVisible, 2);
  EXPECT_EQ(objects[0].maxPixels, 10);
  EXPECT_EQ(objects[1].framesVisible, 0) << "never seen";
  cv::imwrite((folder.path() / "instances/3.0.png").string(), cv::Mat(4, 5, CV_8UC1, cv::Scalar(7)));
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(file); }), HasSubstr("3.0.png: is no image of instance"));
}

TEST(ObjectFilesTest, NamesFileAndLineOfWhatIsWrong) {
  const test::TemporaryFolder folder;
  const auto wrong = folder.write("wrong.csv", std::string(kHeader) + "bed_1,60,bed,-1,x,0,1,2,0.5,30,1600\n");
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(wrong); }), HasSubstr("wrong.csv:2: ymin is 'x'"));
  const auto shorter = folder.write("short.csv", std::string(kHeader) + "bed_1,60\n");
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(shorter); }), HasSubstr("short.csv:2: 2 cells"));
  const auto column = folder.write("column.csv", "name,class_id\nbed_1,60\n");
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(column); }), HasSubstr("no column 'xmin'"));
  EXPECT_THAT(test::complaintOf([&] { return readTrueObjects(folder.path() / "none.csv"); }), HasSubstr("none.csv"));
}

TEST(ObjectFilesTest, ReadsFoundObjectsButThoseThatAreGone) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("objects.json", R"({"objects": [
    {"id": 3, "class_id": 57, "class_name": "chair", "centroid": [1, 2, 3], "box_min": [0, 1, 2], "box_max": [2, 3, 4],
     "probability": 0.9, "views": 5, "zone": "", "state": "moved", "oriented_box": {"size": [1, 2, 3]}},
    {"id": 4, "class_id": 57, "class_name": "chair", "centroid": [1, 2, 3], "box_min": [0, 1, 2], "box_max": [2, 3, 4],
     "probability": 0.9, "views": 5, "zone": "", "state": "gone"}]})");
  const auto objects = readFoundObjects(file);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].id, 3U);
  EXPECT_EQ(objects[0].classId, 57);
  EXPECT_EQ(objects[0].className, "chair");
  EXPECT_EQ(objects[0].centroid_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(objects[0].box_m.max(), Eigen::Vector3d(2, 3, 4));
  EXPECT_EQ(objects[0].orientedSize_m, Eigen::Vector3d(1, 2, 3));
}

TEST(ObjectFilesTest, AFileThatIsNoListOfObjectsSaysSo) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("objects.json", "{\"things\": []}");
  EXPECT_THAT(test::complaintOf([&] { return readFoundObjects(file); }), HasSubstr("is no list of objects"));
  EXPECT_THAT(test::complaintOf([&] { return readFoundObjects(folder.path() / "none.json"); }), HasSubstr("none.json"));
}

}  // namespace
}  // namespace wardslam::evaluation
