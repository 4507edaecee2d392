#pragma once

#include <string>
#include <vector>

#include "wardslam/reproduction/results.h"

namespace wardslam::reproduction {

struct Table {
  std::string name;   ///< "table_1": also that of its file.
  std::string title;  ///< One line.
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;  ///< As many cells as headings.
  std::vector<std::string> notes;              ///< Sentences below it.
  std::size_t labels = 1;                      ///< Columns that say what a row is about; figures are in those behind.
};

/// What a plan came to, for people.
struct TableCollection {
  std::string title;
  std::string introduction;            ///< One line: what the tables are made of.
  std::vector<std::string> sentences;  ///< What is missing, what failed.
  std::vector<Table> tables;
};

/// Fixed point; "–" for NaN.
[[nodiscard]] std::string figureText(double value, int decimals);

/// "0.0104", with several repetitions "0.0104 [0.0101–0.0110]", and "(2 of 3)" behind it where some have no figure; "–"
/// where none has.
[[nodiscard]] std::string spreadText(const Spread& spread, int decimals);

/// Heading, table, notes. Columns are as wide as they need to be.
[[nodiscard]] std::string toMarkdown(const Table& table);

[[nodiscard]] std::string toMarkdown(const TableCollection& collection);

/// Without title and notes; "–" becomes empty.
[[nodiscard]] std::string toCsv(const Table& table);

}  // namespace wardslam::reproduction
