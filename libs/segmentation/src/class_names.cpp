#include "class_names.h"

#include <yaml-cpp/yaml.h>

namespace wardslam::segmentation {
namespace {

constexpr std::size_t kMostClasses = 65536;

/// YAML ends '…' at the next quote, which a backslash does not change; Python writes \' there.
std::string asYaml(std::string_view text) {
  std::string yaml;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isEscapedQuote = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '\'';
    if (isEscapedQuote) yaml += '\'';
    if (!isEscapedQuote) yaml += text[i];
  }
  return yaml;
}

}  // namespace

std::vector<std::string> parseClassNames(std::string_view text) {
  std::vector<std::string> names;
  try {
    const YAML::Node node = YAML::Load(asYaml(text));
    if (node.IsSequence()) return node.as<std::vector<std::string>>();
    if (!node.IsMap()) return {};
    for (const auto& entry : node) {
      const auto index = entry.first.as<std::size_t>();
      if (index >= kMostClasses) return {};
      if (names.size() <= index) names.resize(index + 1);
      names[index] = entry.second.as<std::string>();
    }
  } catch (const YAML::Exception&) {
    return {};
  }
  return names;
}

}  // namespace wardslam::segmentation
