#include "wardslam/pipeline/slam_options.h"

namespace wardslam::pipeline {

core::ConfigNode SlamOptions::defaultFilters() {
  return core::ConfigNode::fromText("[{class_name: 'wardslam::filters::SemanticDynamicFilter'}]", "<defaults>");
}

core::ConfigNode SlamOptions::noFilters() { return core::ConfigNode::fromText("[]", "<defaults>"); }

SlamOptions readSlamOptions(const std::filesystem::path& file) {
  SlamOptions options;
  options.file = file;
  core::OptionReader reader(core::ConfigNode::fromFile(file));
  SlamOptions::describe(options, reader);
  if (const auto filters = reader.opaque("filters"); filters.exists()) options.filters = filters;
  reader.finish();
  return options;
}

std::string writeSlamOptions(const SlamOptions& options, const filters::FilterChain& chain) {
  core::OptionWriter writer;
  SlamOptions::describe(options, writer);
  if (chain.empty()) return writer.text() + "filters: []\n";
  writer.block("filters", chain.parameters(1));
  return writer.text();
}

}  // namespace wardslam::pipeline
