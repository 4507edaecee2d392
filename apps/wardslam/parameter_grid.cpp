#include "parameter_grid.h"

#include <sstream>

#include "support/program.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::apps {
namespace {

constexpr const char* kFilter = "wardslam::filters::SemanticDynamicFilter";

/// Node of the filter's parameters; undefined where the filter is not in use.
YAML::Node filterParameters(const YAML::Node& root) {
  for (const auto& filter : root["filters"]) {
    if (filter["class_name"].as<std::string>("") == kFilter) return filter["params"];
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

/// Paths of all single values below a node.
void addNames(const YAML::Node& node, const std::string& path, std::vector<std::string>& names) {
  for (const auto& entry : node) {
    const std::string name = path + entry.first.as<std::string>();
    if (entry.second.IsScalar()) names.push_back(name);
    if (entry.second.IsMap()) addNames(entry.second, name + ".", names);
  }
}

std::vector<std::string> parameterNames(const YAML::Node& root) {
  std::vector<std::string> names;
  addNames(root, "", names);
  if (const YAML::Node filter = filterParameters(root)) addNames(filter, "filter.", names);
  return names;
}

[[noreturn]] void failUnknown(const std::string& name, const YAML::Node& root) {
  throw core::InputError("--param " + name + ": no such parameter; did you mean '" +
                         core::nearestName(name, parameterNames(root)) + "'?");
}

void set(YAML::Node root, const std::string& name, const std::string& value) {
  std::istringstream path(name);
  std::string key;
  YAML::Node node = root;
  for (bool isFirst = true; std::getline(path, key, '.'); isFirst = false) {
    YAML::Node next = isFirst && key == "filter" ? filterParameters(root) : node.IsMap() ? node[key] : YAML::Node();
    if (!next.IsDefined() || next.IsNull()) failUnknown(name, root);
    node.reset(next);  // plain assignment would change the tree
  }
  if (!node.IsScalar()) failUnknown(name, root);
  node = value;
}

}  // namespace

SweptParameter parseSweptParameter(const std::string& text) {
  const auto equals = text.find('=');
  SweptParameter parameter;
  if (equals != std::string::npos) {
    parameter.name = text.substr(0, equals);
    std::istringstream values(text.substr(equals + 1));
    for (std::string value; std::getline(values, value, ',');) {
      if (!value.empty()) parameter.values.push_back(value);
    }
  }
  if (parameter.name.empty() || parameter.values.empty()) {
    throw UsageError("--param " + text + ": a name and values are needed, as in --param filter.n=5,21,55");
  }
  return parameter;
}

std::vector<GridCell> combinations(const std::vector<SweptParameter>& parameters) {
  std::vector<GridCell> cells = {{}};
  for (const SweptParameter& parameter : parameters) {
    std::vector<GridCell> longer;
    for (const GridCell& cell : cells) {
      for (const std::string& value : parameter.values) {
        longer.push_back(cell);
        longer.back().push_back(value);
      }
    }
    cells = std::move(longer);
  }
  return cells;
}

std::string nameOf(const std::vector<SweptParameter>& parameters, const GridCell& cell) {
  std::string name;
  for (std::size_t i = 0; i < cell.size(); ++i) name += (i > 0 ? "," : "") + parameters[i].name + "=" + cell[i];
  return name;
}

core::ConfigNode withParameters(const std::string& configuration, const std::filesystem::path& file,
                                const std::vector<SweptParameter>& parameters, const GridCell& cell) {
  const YAML::Node root = YAML::Load(configuration);
  for (std::size_t i = 0; i < cell.size(); ++i) set(root, parameters[i].name, cell[i]);
  return {root, file.empty() ? std::filesystem::path("<defaults>") : file};
}

}  // namespace wardslam::apps
