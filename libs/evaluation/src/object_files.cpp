#include "wardslam/evaluation/object_files.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "instance_visibility.h"
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
  return object;
}

/// Tells how well things were seen: by two columns or, where rawlog-synth wrote the file, by the images of instances
/// beside it.
class VisibilityOf {
 public:
  VisibilityOf(const std::filesystem::path& file, const std::vector<std::string>& columns) {
    const auto isThere = [&](const char* name) { return std::count(columns.begin(), columns.end(), name) > 0; };
    if (isThere("frames_visible") || !isThere("instance_id")) return;
    const auto instances = file.parent_path() / "instances";
    if (!std::filesystem::is_directory(instances)) {
      throw core::InputError(file.string() + ": says by no column frames_visible how well things were seen, and " +
                             instances.string() + " is not there to count it in");
    }
    counted_ = countVisibility(instances);
  }

  [[nodiscard]] Visibility of(const Row& row, const std::string& where) const {
    const auto whole = [&](const char* column) { return static_cast<int>(number(row, column, where)); };
    if (!counted_) return {whole("frames_visible"), whole("max_pixels")};
    const auto found = counted_->find(whole("instance_id"));
    return found == counted_->end() ? Visibility{} : found->second;
  }

 private:
  std::optional<std::map<int, Visibility>> counted_;
};

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
  const VisibilityOf visibility(file, columns);
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
    const Visibility seen = visibility.of(row, where);
    objects.back().framesVisible = seen.frames;
    objects.back().maxPixels = seen.maxPixels;
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
