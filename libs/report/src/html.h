#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

/// Pieces of a page. What is called text is escaped here; what is called html is not.
namespace wardslam::report {

[[nodiscard]] std::string fixed(double value, int decimals);

/// `data:` address of an image: ".jpg" or ".png". Throws cv::Exception where it cannot be encoded.
[[nodiscard]] std::string dataAddress(const cv::Mat& image, const std::string& type);

/// "12.3 s", counted from the start of the run; a time outside of the run is given by day and hour.
[[nodiscard]] std::string timeText(double stamp_s, double start_s, double end_s);

/// "2026-11-29 05:26:15 UTC"; of stamps that tell no day, nothing.
[[nodiscard]] std::string dayText(double stamp_s);

/// `rows`: text; all but the first column are aligned to the right where they are numbers.
[[nodiscard]] std::string table(const std::vector<std::string>& headings,
                                const std::vector<std::vector<std::string>>& rows);

/// The first `labels` columns to the left, all others to the right, also where they say why there is no figure.
[[nodiscard]] std::string tableOfFigures(const std::vector<std::string>& headings,
                                         const std::vector<std::vector<std::string>>& rows, std::size_t labels);

/// Everything to <body>, with the style of all pages and what else `css` says. Nothing may be loaded from elsewhere,
/// whatever a name in a file says. `title`: text.
[[nodiscard]] std::string pageHead(const std::string& title, const std::string& css);

/// The end of a page.
[[nodiscard]] std::string pageEnd();

/// Sentences that a page begins with; nothing where there are none.
[[nodiscard]] std::string remarks(const std::vector<std::string>& sentences);

/// What share/report has.
[[nodiscard]] std::string dataFile(const char* name);

/// A part of the page with a heading of its own; nothing where there is nothing in it.
[[nodiscard]] std::string section(const std::string& id, const std::string& heading, const std::string& html);

}  // namespace wardslam::report
