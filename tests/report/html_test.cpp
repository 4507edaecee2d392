#include "html.h"

#include <gmock/gmock.h>
#include <mrpt/system/string_utils.h>

#include <opencv2/imgcodecs.hpp>

namespace wardslam::report {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Html, TimesWithinTheRunCountFromItsStart) {
  EXPECT_EQ(timeText(1012.34, 1000.0, 1020.0), "12.3 s");
  EXPECT_EQ(timeText(999.5, 1000.0, 1020.0), "-0.5 s");
}

TEST(Html, OtherTimesAreDaysWhereStampsTellADay) {
  constexpr double kStart_s = 1.7e9;  // 2023-11-14 22:13:20 UTC
  EXPECT_EQ(dayText(kStart_s), "2023-11-14 22:13:20 UTC");
  EXPECT_EQ(timeText(kStart_s - 86400.0, kStart_s, kStart_s + 60.0), "2023-11-13 22:13:20 UTC");
  EXPECT_EQ(dayText(12.5), "");
  EXPECT_EQ(timeText(100.0, 0.0, 10.0), "100.0 s");
}

TEST(Html, TablesEscapeTextAndAlignNumbers) {
  const std::string html = table({"name", "<i>", "note"}, {{"7", "-12.5 %", "3 chairs"}, {"a&b", "4 m²", "0.1.0"}});
  EXPECT_THAT(html, HasSubstr("<th>name</th><th class=\"number\">&lt;i&gt;</th><th>note</th>"));
  EXPECT_THAT(html, HasSubstr("<td>7</td><td class=\"number\">-12.5 %</td><td>3 chairs</td>"));
  EXPECT_THAT(html, HasSubstr("<td>a&amp;b</td><td class=\"number\">4 m²</td><td>0.1.0</td>"));
}

TEST(Html, SectionsOfNothingAreNotThere) {
  EXPECT_THAT(section("id", "Heading", ""), IsEmpty());
  EXPECT_EQ(section("id", "A & B", "<p>text</p>"), "<section id=\"id\"><h2>A &amp; B</h2>\n<p>text</p></section>\n");
}

TEST(Html, ImagesTravelInTheirAddress) {
  const cv::Mat image = (cv::Mat_<cv::Vec3b>(1, 2) << cv::Vec3b(1, 2, 3), cv::Vec3b(250, 251, 252));
  const std::string address = dataAddress(image, ".png");
  const std::string begin = "data:image/png;base64,";
  ASSERT_THAT(address, StartsWith(begin));
  EXPECT_THAT(address, Not(HasSubstr("\n")));
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(mrpt::system::decodeBase64(address.substr(begin.size()), bytes));
  const cv::Mat back = cv::imdecode(bytes, cv::IMREAD_COLOR);
  ASSERT_EQ(back.size(), image.size());
  EXPECT_EQ(cv::norm(back, image, cv::NORM_INF), 0.0);
  EXPECT_THAT(dataAddress(image, ".jpg"), StartsWith("data:image/jpeg;base64,"));
}

}  // namespace
}  // namespace wardslam::report
