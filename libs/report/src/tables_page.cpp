#include "wardslam/report/tables_page.h"

#include "html.h"
#include "wardslam/core/markup.h"

namespace wardslam::report {
namespace {

using core::escapedForMarkup;

std::string partOf(const reproduction::Table& table) {
  std::string html = tableOfFigures(table.headings, table.rows, table.labels);
  for (const std::string& note : table.notes) html += "<p class=\"key\">" + escapedForMarkup(note) + "</p>\n";
  return section(table.name, table.title, html);
}

}  // namespace

std::string makeTablesPage(const reproduction::TableCollection& collection) {
  std::string html = pageHead(collection.title, {}) + "<h1>" + escapedForMarkup(collection.title) + "</h1>\n<p>" +
                     escapedForMarkup(collection.introduction) + "</p>\n" + remarks(collection.sentences);
  for (const reproduction::Table& table : collection.tables) html += partOf(table);
  return html + pageEnd();
}

}  // namespace wardslam::report
