#include "wardslam/pipeline/slam_options.h"

#include <regex>

namespace wardslam::pipeline {
namespace {

constexpr const char* kSemanticFilter = "wardslam::filters::SemanticDynamicFilter";

/// A file that lies beside the one that names it, by its full path, so that the options can be written elsewhere.
std::string located(const std::string& name, const std::filesystem::path& referringFile) {
  const auto beside = std::filesystem::absolute(referringFile).parent_path() / name;
  return std::filesystem::exists(beside) ? beside.lexically_normal().string() : name;
}

}  // namespace

core::ConfigNode SlamOptions::defaultFilters() {
  return core::ConfigNode::fromText(
      "[{class_name: 'wardslam::filters::SemanticDynamicFilter'}, "
      "{class_name: 'wardslam::filters::GeometricMotionFilter'}]",
      "<defaults>");
}

core::ConfigNode SlamOptions::noFilters() { return core::ConfigNode::fromText("[]", "<defaults>"); }

bool SlamOptions::setFilterParameter(const std::string& className, const std::string& key, const std::string& value) {
  bool isFound = false;
  for (YAML::Node filter : YAML::Node(filters.yaml())) {  // a node is a handle: this changes what it stands for
    if (!filter.IsMap() || filter["class_name"].as<std::string>("") != className) continue;
    filter["params"][key] = value;
    isFound = true;
  }
  return isFound;
}

void SlamOptions::keepOnlyFilters(const std::string& className) {
  if (!filters.yaml().IsSequence()) return;  // the chain will say what is wrong
  YAML::Node kept(YAML::NodeType::Sequence);
  for (const YAML::Node& filter : filters.yaml()) {
    if (filter.IsMap() && filter["class_name"].as<std::string>("") == className) kept.push_back(filter);
  }
  if (kept.size() == 0) {
    YAML::Node withDefaults;
    withDefaults["class_name"] = className;
    kept.push_back(withDefaults);
  }
  filters = core::ConfigNode(kept, filters.file(), filters.key());
}

bool SlamOptions::segments() const {
  using Type = segmentation::SegmentationOptions::Type;
  if (segmentation.type != Type::Depth) return segmentation.type != Type::None;
  if (!filters.yaml().IsSequence()) return true;  // the chain will say what is wrong
  for (const YAML::Node& filter : filters.yaml()) {
    if (filter.IsMap() && filter["class_name"].as<std::string>("") == kSemanticFilter) return true;
  }
  return false;
}

void SlamOptions::removeFilters(const std::string& className) {
  if (!filters.yaml().IsSequence()) return;
  YAML::Node kept(YAML::NodeType::Sequence);
  for (const YAML::Node& filter : filters.yaml()) {
    if (!filter.IsMap() || filter["class_name"].as<std::string>("") != className) kept.push_back(filter);
  }
  filters = core::ConfigNode(kept, filters.file(), filters.key());
}

SlamOptions readSlamOptions(const std::filesystem::path& file) {
  return readSlamOptions(core::ConfigNode::fromFile(file));
}

SlamOptions readSlamOptions(const core::ConfigNode& root) {
  const std::filesystem::path& file = root.file();
  SlamOptions options;
  options.file = file;
  core::OptionReader reader(root);
  SlamOptions::describe(options, reader);
  if (const auto filters = reader.opaque("filters"); filters.exists()) options.filters = filters;
  reader.finish();
  options.knowledge.file = located(options.knowledge.file, file);
  if (!options.zones.file.empty()) options.zones.file = located(options.zones.file, file);
  return options;
}

std::string writeSlamOptions(const SlamOptions& options, const filters::FilterChain& chain) {
  core::OptionWriter writer;
  SlamOptions::describe(options, writer);
  if (chain.empty()) return writer.text() + "filters: []\n";  // a key without a value would mean the default
  writer.block("filters", chain.parameters(1));
  return writer.text();
}

std::string withoutFolders(const std::string& yaml) {
  static const std::regex kAbsolutePath(R"re((: ["']?)/(?:[^/"'\n]+/)*([^/"'\n]*))re");
  return std::regex_replace(yaml, kAbsolutePath, "$1$2");
}

}  // namespace wardslam::pipeline
