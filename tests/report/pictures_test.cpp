#include "pictures.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temporary_folder.h"

namespace wardslam::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Pictures, AreChosenEvenlyWithTheFirstAndTheLast) {
  EXPECT_THAT(evenlyChosen(0, 4), IsEmpty());
  EXPECT_THAT(evenlyChosen(1, 4), ElementsAre(0));
  EXPECT_THAT(evenlyChosen(3, 4), ElementsAre(0, 1, 2));
  EXPECT_THAT(evenlyChosen(11, 3), ElementsAre(0, 5, 10));
  EXPECT_THAT(evenlyChosen(5, 1), ElementsAre(0));
}

class PicturesOfRun : public ::testing::Test {
 protected:
  PicturesOfRun() {
    run.pictures = {folder.path() / "1000.000000.jpg"};
    cv::imwrite(run.pictures.front().string(), cv::Mat(30, 40, CV_8UC3, cv::Scalar(10, 200, 30)));
    run.summary = {{"pictures", {{"interval", 10}, {"people_kept", false}}}};
  }

  test::TemporaryFolder folder;
  RunRecord run;
  std::vector<std::string> missing;
};

TEST_F(PicturesOfRun, AreShownWherePeopleAreBlanked) {
  EXPECT_THAT(picturesOf(run, false, missing), HasSubstr("src=\"data:image/jpeg;base64,"));
  EXPECT_THAT(missing, IsEmpty());
}

TEST_F(PicturesOfRun, AreLeftOutWhereTheyMayShowPeople) {
  for (const char* summary : {R"({"pictures": {"interval": 10, "people_kept": true}})", R"({"pictures": 7})", "{}"}) {
    run.summary = nlohmann::ordered_json::parse(summary);
    missing.clear();
    EXPECT_THAT(picturesOf(run, false, missing), IsEmpty()) << summary;
    EXPECT_THAT(missing, ElementsAre(HasSubstr("--keep-people"))) << summary;
    EXPECT_THAT(picturesOf(run, true, missing), Not(IsEmpty())) << summary;
  }
}

TEST_F(PicturesOfRun, ThatCannotBeReadCostASentence) {
  run.pictures.push_back(folder.write("1001.000000.jpg", "no picture"));
  EXPECT_THAT(picturesOf(run, false, missing), HasSubstr("<img"));
  EXPECT_THAT(missing, ElementsAre("pictures/1001.000000.jpg cannot be read."));
}

}  // namespace
}  // namespace wardslam::report
