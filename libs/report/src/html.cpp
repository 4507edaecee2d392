#include "html.h"

#include <mrpt/system/string_utils.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "wardslam/core/data_files.h"
#include "wardslam/core/markup.h"

namespace wardslam::report {
namespace {

using core::escapedForMarkup;

/// "12.3 %" and "-0.5", not "3 chairs" nor "0.1.0".
bool isNumber(const std::string& text) {
  constexpr std::size_t kLongestUnit = 4;  // " m²"
  const std::string number = text.substr(0, text.find(' '));
  return !number.empty() && text.size() - number.size() <= kLongestUnit &&
         number.find_first_not_of("-.0123456789") == std::string::npos &&
         std::count(number.begin(), number.end(), '.') <= 1;
}

/// `isRight(text, column)`: aligned to the right; a heading is where all below it are.
template <class IsRight>
std::string tableOf(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows,
                    const char* tag, IsRight isRight) {
  const auto isRightAll = [&](std::size_t column) {
    return std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return isRight(row[column], column); });
  };
  std::string html = std::string("<div class=\"wide\">") + tag + "\n<thead><tr>";
  for (std::size_t i = 0; i < headings.size(); ++i) {
    html += (isRightAll(i) ? "<th class=\"number\">" : "<th>") + escapedForMarkup(headings[i]) + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += (isRight(row[i], i) ? "<td class=\"number\">" : "<td>") + escapedForMarkup(row[i]) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string fixed(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string dataAddress(const cv::Mat& image, const std::string& type) {
  constexpr int kJpegQuality = 78;
  std::vector<std::uint8_t> bytes;
  const bool isPng = type == ".png";
  cv::imencode(type, image, bytes,
               isPng ? std::vector<int>{} : std::vector<int>{cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  std::string text;
  mrpt::system::encodeBase64(bytes, text);
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }), text.end());
  return std::string(isPng ? "data:image/png;base64," : "data:image/jpeg;base64,") + text;
}

std::string dayText(double stamp_s) {
  constexpr double kTellsADay_s = 1e8;  // those of --private, and of clocks that were not set, do not
  if (!(stamp_s > kTellsADay_s && stamp_s < 1e11)) return {};
  const auto seconds = static_cast<std::time_t>(stamp_s);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::ostringstream text;
  text << std::put_time(&utc, "%Y-%m-%d %H:%M:%S UTC");
  return text.str();
}

std::string timeText(double stamp_s, double start_s, double end_s) {
  constexpr double kMargin_s = 1.0;
  const bool isWithin = stamp_s >= start_s - kMargin_s && stamp_s <= end_s + kMargin_s;
  const std::string day = isWithin ? std::string() : dayText(stamp_s);
  return day.empty() ? fixed(stamp_s - start_s, 1) + " s" : day;
}

std::string table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows) {
  return tableOf(headings, rows, "<table>",
                 [](const std::string& text, std::size_t column) { return column > 0 && isNumber(text); });
}

std::string tableOfFigures(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows,
                           std::size_t labels) {
  return tableOf(headings, rows, "<table class=\"comparison\">",
                 [labels](const std::string&, std::size_t column) { return column >= labels; });
}

std::string dataFile(const char* name) {
  std::ifstream in(core::findDataFile(std::filesystem::path("report") / name));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string pageHead(const std::string& title, const std::string& css) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
         "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         escapedForMarkup(title) + "</title>\n<style>\n" + css + dataFile("report.css") + "</style>\n</head>\n<body>\n";
}

std::string pageEnd() { return "</body>\n</html>\n"; }

std::string remarks(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string html = "<ul class=\"missing\">\n";
  for (const auto& sentence : sentences) html += "<li>" + escapedForMarkup(sentence) + "</li>\n";
  return html + "</ul>\n";
}

std::string section(const std::string& id, const std::string& heading, const std::string& html) {
  if (html.empty()) return {};
  return "<section id=\"" + id + "\"><h2>" + escapedForMarkup(heading) + "</h2>\n" + html + "</section>\n";
}

}  // namespace wardslam::report
