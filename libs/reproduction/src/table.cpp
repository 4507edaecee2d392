#include "wardslam/reproduction/table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace wardslam::reproduction {
namespace {

constexpr const char* kUnknown = "–";

/// Characters, not bytes.
std::size_t widthOf(const std::string& utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string quoted(const std::string& cell) {
  if (cell == kUnknown) return "";
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

std::string figureText(double value, int decimals) {
  if (std::isnan(value)) return kUnknown;
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string spreadText(const Spread& spread, int decimals) {
  std::string text = figureText(spread.median, decimals);
  if (spread.known > 1) {
    text += " [" + figureText(spread.min, decimals) + "–" + figureText(spread.max, decimals) + "]";
  }
  if (spread.known > 0 && spread.known < spread.runs) {
    text += " (" + std::to_string(spread.known) + " of " + std::to_string(spread.runs) + ")";
  }
  return text;
}

std::string toMarkdown(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    widths.push_back(std::max<std::size_t>(3, widthOf(table.headings[i])));
    for (const auto& row : table.rows) widths[i] = std::max(widths[i], widthOf(row[i]));
  }
  std::string text = "## " + table.title + "\n\n";
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += "| " + row[i] + std::string(widths[i] - widthOf(row[i]) + 1, ' ');
    text += "|\n";
  };
  add(table.headings);
  for (const std::size_t width : widths) text += "|" + std::string(width + 2, '-');
  text += "|\n";
  for (const auto& row : table.rows) add(row);
  for (const std::string& note : table.notes) text += "\n" + note + "\n";
  return text;
}

std::string toMarkdown(const TableCollection& collection) {
  std::string text = "# " + collection.title + "\n\n" + collection.introduction + "\n";
  for (const std::string& sentence : collection.sentences) text += "\n- " + sentence;
  if (!collection.sentences.empty()) text += "\n";
  for (const Table& table : collection.tables) text += "\n" + toMarkdown(table);
  return text;
}

std::string toCsv(const Table& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + quoted(row[i]);
    text += "\n";
  };
  add(table.headings);
  for (const auto& row : table.rows) add(row);
  return text;
}

}  // namespace wardslam::reproduction
