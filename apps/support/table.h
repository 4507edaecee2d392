#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace wardslam::apps {

/// Text in columns as wide as they need to be; what looks like a number stands to the right.
class Table {
 public:
  explicit Table(std::vector<std::string> headings) : rows_{std::move(headings)} {}

  /// As many cells as there are headings.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  void print(std::ostream& out) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// Fixed point, so many digits after it; "-" for NaN.
[[nodiscard]] std::string fixed(double value, int decimals);

}  // namespace wardslam::apps
