#include "wardslam/reproduction/published_figures.h"

#include <algorithm>

#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::reproduction {
namespace {

using core::ConfigNode;

using FiguresOfSequence = std::map<std::string, std::string>;

FiguresOfSequence readFigures(const ConfigNode& node) {
  node.requireKeys({"ate_rmse_m", "ate_mean_m", "ate_median_m", "ate_std_m", "rpe_translation_mps",
                    "rpe_rotation_degps", "filter_ms"});
  FiguresOfSequence figures;
  for (const auto& entry : node.yaml()) {
    double figure = 0.0;
    if (!entry.second.IsScalar() || !YAML::convert<double>::decode(entry.second, figure) || !(figure >= 0.0)) {
      node.child(entry.first.Scalar()).fail("a number that is not negative is expected here");
    }
    figures[entry.first.Scalar()] = entry.second.Scalar();
  }
  return figures;
}

std::vector<int> readTables(const ConfigNode& node) {
  std::vector<int> tables;
  if (!node.exists() || !node.yaml().IsSequence()) node.fail("a list of the tables it stands in is expected here");
  for (std::size_t i = 0; i < node.yaml().size(); ++i) {
    int table = 0;
    const ConfigNode item = node.item(i);
    if (!YAML::convert<int>::decode(item.yaml(), table) || table < 1 || table > 7) {
      item.fail("the number of a table, 1 to 7, is expected here");
    }
    tables.push_back(table);
  }
  return tables;
}

PublishedSystem readSystem(const ConfigNode& node) {
  PublishedSystem system;
  core::OptionReader reader(node);
  reader("name", system.name, "");
  reader("source", system.source, "");
  reader("alignment", system.alignment, "");
  reader("gpu", system.gpu, "");
  system.tables = readTables(reader.opaque("tables"));
  const ConfigNode figures = reader.opaque("figures");
  reader.finish();
  if (system.name.empty() || system.source.empty()) node.fail("'name' and 'source' are needed");
  if (!system.alignment.empty() && system.alignment != "SE(3)" && system.alignment != "Sim(3)") {
    node.child("alignment").fail("SE(3) or Sim(3) is expected here");
  }
  if (!figures.exists() || !figures.yaml().IsMap()) node.fail("'figures' are missing");
  for (const auto& entry : figures.yaml()) {
    const std::string& sequence = entry.first.Scalar();
    system.figures[sequence] = readFigures(figures.child(sequence));
  }
  return system;
}

}  // namespace

std::string PublishedSystem::of(const std::string& sequence, const std::string& figure) const {
  const auto ofSequence = figures.find(sequence);
  if (ofSequence == figures.end()) return "–";
  const auto found = ofSequence->second.find(figure);
  return found == ofSequence->second.end() ? "–" : found->second;
}

bool PublishedSystem::isIn(int table) const { return std::find(tables.begin(), tables.end(), table) != tables.end(); }

std::string PublishedSystem::heading() const {
  std::string marks = gpu ? "GPU" : "";
  if (alignment == "Sim(3)") marks += marks.empty() ? alignment : ", " + alignment;
  return marks.empty() ? name : name + " (" + marks + ")";
}

std::vector<PublishedSystem> readPublishedFigures(const std::filesystem::path& file) {
  const ConfigNode root = ConfigNode::fromFile(file);
  root.requireKeys({"systems"});
  const ConfigNode list = root.child("systems");
  if (!list.exists() || !list.yaml().IsSequence()) root.fail("a list 'systems' is expected here");
  std::vector<PublishedSystem> systems;
  for (std::size_t i = 0; i < list.yaml().size(); ++i) systems.push_back(readSystem(list.item(i)));
  return systems;
}

}  // namespace wardslam::reproduction
