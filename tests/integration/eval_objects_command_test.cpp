#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli_test_support.h"
#include "support/temporary_folder.h"

namespace wardslam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A ward with two beds seen well and a chair hardly seen. The run's map stands 10 m aside of the truth, and holds a
/// bed at its place, half a metre of another where there is none, and nothing of the second bed.
class EvalObjectsCommand : public ::testing::Test {
 protected:
  [[nodiscard]] test::CommandResult evalObjects(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"eval-objects",   truth,      objects, "--trajectory", trajectory,
                                       "--ground-truth", groundTruth};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::runProgram("wardslam", arguments);
  }

  std::string write(const std::string& name, const std::string& text) const {
    return folder.write(name, text).string();
  }

  test::TemporaryFolder folder;
  const std::string truth = write("objects.csv",
                                  "name,class_id,class_name,xmin,ymin,zmin,xmax,ymax,zmax,frames_visible,max_pixels\n"
                                  "bed_1,60,bed,0,0,0,2,1,0.6,30,9000\n"
                                  "bed_2,60,bed,5,0,0,7,1,0.6,30,9000\n"
                                  "chair_1,57,chair,3,3,0,3.5,3.5,0.9,2,100\n");
  const std::string objects = write("objects.json", R"({"objects": [
    {"id": 3, "class_id": 60, "class_name": "bed", "centroid": [11, 0.5, 0.3], "box_min": [10, 0, 0],
     "box_max": [12.2, 1, 0.6], "probability": 0.9, "views": 9, "zone": "", "state": "static",
     "oriented_box": {"size": [2.2, 1, 0.6]}},
    {"id": 4, "class_id": 60, "class_name": "bed", "centroid": [13, 8, 0.3], "box_min": [12.75, 7.5, 0],
     "box_max": [13.25, 8.5, 0.6], "probability": 0.9, "views": 9, "zone": "", "state": "static",
     "oriented_box": {"size": [0.5, 1, 0.6]}}]})");
  const std::string groundTruth = write("groundtruth.txt",
                                        "0.0 1 0 0 0 0 0 1\n"
                                        "0.1 0 1 0 0 0 0 1\n"
                                        "0.2 0 0 1 0 0 0 1\n");
  const std::string trajectory = write("trajectory.txt",
                                       "0.0 11 0 0 0 0 0 1\n"
                                       "0.1 10 1 0 0 0 0 1\n"
                                       "0.2 10 0 1 0 0 0 1\n");
};

TEST_F(EvalObjectsCommand, CountsWhatWasFoundAndWhatIsTrueOfIt) {
  const auto result = evalObjects({"--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("wanted"), 2) << "the chair was hardly seen";
  EXPECT_EQ(json.at("wanted_found"), 1);
  EXPECT_EQ(json.at("found"), 2);
  EXPECT_EQ(json.at("found_true"), 1);
  EXPECT_NEAR(json.at("center_error_m").at("median").get<double>(), 0.1, 1e-6);
}

TEST_F(EvalObjectsCommand, PrintsATable) {
  const auto result = evalObjects();
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out,
            "class  wanted  got  recall  found  true  precision\n"
            "bed         2    1   0.500      2     1      0.500\n"
            "all         2    1   0.500      2     1      0.500\n"
            "box centre: median error 0.100 m; size: 0.200 m\n");
}

TEST_F(EvalObjectsCommand, ListsWhatIsTrueMissedAndFalse) {
  const auto result = evalObjects({"--objects"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("true   bed_1 = 3, centre off by 0.100 m"), HasSubstr("missed bed_2"),
                                HasSubstr("false  4 bed at")));
}

TEST_F(EvalObjectsCommand, SaysWhichFileIsMissing) {
  const auto result = test::runProgram(
      "wardslam", {"eval-objects", truth, "none.json", "--trajectory", trajectory, "--ground-truth", groundTruth});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("none.json"));
}

}  // namespace
}  // namespace wardslam
