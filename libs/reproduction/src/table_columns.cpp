#include "table_columns.h"

#include <algorithm>

namespace wardslam::reproduction {
namespace {

/// Those of one source share a note.
void addSource(Table& table, const PublishedSystem& system) {
  const std::string source = ": " + system.source + ".";
  for (std::string& note : table.notes) {
    const auto at = note.find(source);
    if (at == std::string::npos) continue;
    note.insert(at, "; " + system.heading());
    return;
  }
  table.notes.push_back(system.heading() + source);
}

}  // namespace

Table Tables::begin(const std::string& name, const std::string& title, const std::vector<std::string>& cases) const {
  Table table;
  table.name = name;
  table.title = title;
  table.headings = {"Sequence"};
  for (const std::string& row : cases) table.rows.push_back({row});
  for (const Sequence& sequence : plan_.sequences) table.rows.push_back({sequence.name});
  return table;
}

void Tables::addPublished(Table& table, int number, std::initializer_list<PublishedColumn> columns) const {
  for (const PublishedSystem& system : published_) {
    if (!system.isIn(number)) continue;
    const bool isOfUse = std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
      return std::any_of(columns.begin(), columns.end(),
                         [&](const PublishedColumn& column) { return system.of(row.front(), column.figure) != "–"; });
    });
    if (!isOfUse) continue;
    for (const PublishedColumn& column : columns) {
      table.headings.push_back(system.heading() + column.suffix);
      for (auto& row : table.rows) row.push_back(system.of(row.front(), column.figure));
    }
    addSource(table, system);
  }
}

std::string Tables::ownCell(std::size_t sequence, std::size_t variant, const OwnColumn& column) const {
  if (results_.of(sequence, variant).empty()) {
    const std::string why = results_.whyAbsent(sequence, variant);
    return why.empty() ? "–" : why;
  }
  return spreadText(results_.spread(sequence, variant, column.figure), column.decimals);
}

void Tables::addOwn(Table& table, const std::function<bool(const Variant&)>& isWanted,
                    std::initializer_list<OwnColumn> columns) const {
  const std::size_t cases = table.rows.size() - plan_.sequences.size();
  for (std::size_t variant = 0; variant < plan_.variants.size(); ++variant) {
    if (!isWanted(plan_.variants[variant])) continue;
    for (const OwnColumn& column : columns) {
      table.headings.push_back(plan_.variants[variant].name + column.suffix);
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        table.rows[row].push_back(row < cases ? "–" : ownCell(row - cases, variant, column));
      }
    }
  }
}

}  // namespace wardslam::reproduction
