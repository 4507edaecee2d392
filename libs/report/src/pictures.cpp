#include "pictures.h"

#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "html.h"
#include "wardslam/core/markup.h"

namespace wardslam::report {
namespace {

constexpr std::size_t kMost = 24;
constexpr int kWidth_px = 480;

/// summary.json says what the run did with people.
bool showsNobody(const RunRecord& run) {
  const auto pictures = run.summary.find("pictures");
  if (pictures == run.summary.end() || !pictures->is_object()) return false;
  const auto people = pictures->find("people_kept");
  return people != pictures->end() && people->is_boolean() && !people->get<bool>();
}

cv::Mat narrowed(const cv::Mat& picture) {
  if (picture.cols <= kWidth_px) return picture;
  cv::Mat narrow;
  cv::resize(picture, narrow, cv::Size(kWidth_px, std::max(1, picture.rows * kWidth_px / picture.cols)), 0, 0,
             cv::INTER_AREA);
  return narrow;
}

}  // namespace

std::vector<std::size_t> evenlyChosen(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t number = std::min(count, most);
  for (std::size_t i = 0; i < number; ++i) chosen.push_back(number == 1 ? 0 : i * (count - 1) / (number - 1));
  return chosen;
}

std::string picturesOf(const RunRecord& run, bool keepPeople, std::vector<std::string>& missing) {
  if (run.pictures.empty()) return {};
  if (!keepPeople && !showsNobody(run)) {
    missing.emplace_back(
        "Pictures are left out: nothing says that people are blanked in them; --keep-people shows them as they are.");
    return {};
  }
  std::string html;
  for (const std::size_t i : evenlyChosen(run.pictures.size(), kMost)) {
    const auto& file = run.pictures[i];
    const cv::Mat picture = cv::imread(file.string(), cv::IMREAD_COLOR);
    if (picture.empty()) {
      missing.push_back("pictures/" + file.filename().string() + " cannot be read.");
      continue;
    }
    const std::string time = timeText(std::strtod(file.stem().c_str(), nullptr), run.start_s(), run.end_s());
    html += "<figure><img loading=\"lazy\" alt=\"the image at " + time + "\" src=\"" +
            dataAddress(narrowed(picture), ".jpg") + "\"><figcaption>" + core::escapedForMarkup(time) +
            "</figcaption></figure>\n";
  }
  if (html.empty()) return html;
  return "<p class=\"key\">What moves is red and left out, with its key points; those the pose may rest on are "
         "green.</p>\n"
         "<div class=\"pictures\">\n" +
         html + "</div>\n";
}

}  // namespace wardslam::report
