#include "support/table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace wardslam::apps {
namespace {

bool looksLikeNumber(const std::string& cell) {
  if (cell == "-") return true;  // there is none
  return std::any_of(cell.begin(), cell.end(), [](unsigned char c) { return std::isdigit(c) != 0; }) &&
         cell.find_first_not_of("0123456789.+-") == std::string::npos;
}

}  // namespace

void Table::print(std::ostream& out) const {
  std::vector<std::size_t> widths(rows_.front().size());
  std::vector<bool> isNumber(widths.size(), rows_.size() > 1);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for (std::size_t column = 0; column < widths.size(); ++column) {
      const std::string& cell = rows_[row].at(column);
      widths[column] = std::max(widths[column], cell.size());
      if (row > 0 && !cell.empty() && !looksLikeNumber(cell)) isNumber[column] = false;
    }
  }
  for (const auto& row : rows_) {
    std::ostringstream line;
    for (std::size_t column = 0; column < widths.size(); ++column) {
      line << (column > 0 ? "  " : "") << (isNumber[column] ? std::right : std::left)
           << std::setw(static_cast<int>(widths[column])) << row[column];
    }
    std::string text = line.str();
    text.erase(text.find_last_not_of(' ') + 1);
    out << text << "\n";
  }
}

std::string fixed(double value, int decimals) {
  if (std::isnan(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

}  // namespace wardslam::apps
