#include "wardslam/evaluation/object_files.h"

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "wardslam/core/errors.h"

namespace wardslam::evaluation {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream text(line);
  for (std::string part; std::getline(text, part, ',');) {
    if (!part.empty() && part.back() == '\r') part.pop_back();
    parts.push_back(part);
  }
  return parts;
}

double number(const Row& row, const std::string& column, const std::string& where) {
  const auto cell = row.find(column);
  if (cell == row.end()) throw core::InputError(where + ": there is no column '" + column + "'; name it in line 1");
  std::istringstream text(cell->second);
  double value = 0.0;
  if (!(text >> value) || !(text >> std::ws).eof()) {
    throw core::InputError(where + ": " + column + " is '" + cell->second + "'; a number is expected there");
  }
  return value;
}

TrueObject trueObject(const Row& row, const std::string& where) {
  TrueObject object;
  const auto text = [&](const std::string& column) { return row.count(column) > 0 ? row.at(column) : std::string(); };
  object.name = text("name");
  object.className = text("class_name");
  object.classId = static_cast<core::ClassId>(number(row, "class_id", where));
  object.box_m.min() = {number(row, "xmin", where), number(row, "ymin", where), number(row, "zmin", where)};
  object.box_m.max() = {number(row, "xmax", where), number(row, "ymax", where), number(row, "zmax", where)};
  object.framesVisible = static_cast<int>(number(row, "frames_visible", where));
  object.maxPixels = static_cast<int>(number(row, "max_pixels", where));
  return object;
}

Eigen::Vector3d vector(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

FoundObject foundObject(const nlohmann::json& json) {
  FoundObject object;
  object.id = json.at("id").get<unsigned>();
  object.classId = json.at("class_id").get<core::ClassId>();
  object.className = json.at("class_name").get<std::string>();
  object.centroid_m = vector(json.at("centroid"));
  object.box_m = {vector(json.at("box_min")), vector(json.at("box_max"))};
  if (json.contains("oriented_box")) object.orientedSize_m = vector(json.at("oriented_box").at("size"));
  return object;
}

}  // namespace

std::vector<TrueObject> readTrueObjects(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) throw core::InputError(file.string() + ": cannot be read, or is empty");
  const std::vector<std::string> columns = cells(line);
  std::vector<TrueObject> objects;
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    const std::string where = file.string() + ":" + std::to_string(number);
    const auto parts = cells(line);
    if (parts.size() != columns.size()) {
      throw core::InputError(where + ": " + std::to_string(parts.size()) + " cells where line 1 names " +
                             std::to_string(columns.size()));
    }
    Row row;
    for (std::size_t i = 0; i < parts.size(); ++i) row[columns[i]] = parts[i];
    objects.push_back(trueObject(row, where));
  }
  return objects;
}

std::vector<FoundObject> readFoundObjects(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw core::InputError(file.string() + ": cannot be read");
  try {
    std::vector<FoundObject> objects;
    const auto document = nlohmann::json::parse(in);
    for (const auto& json : document.at("objects")) {
      if (json.value("state", "") != "gone") objects.push_back(foundObject(json));
    }
    return objects;
  } catch (const nlohmann::json::exception& error) {
    throw core::InputError(file.string() + ": is no list of objects as `wardslam run` writes it (" + error.what() +
                           ")");
  }
}

}  // namespace wardslam::evaluation
