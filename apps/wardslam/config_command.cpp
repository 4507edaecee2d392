#include "config_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "wardslam/core/data_files.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/masks/async_segmenter.h"
#include "wardslam/pipeline/slam_options.h"

namespace wardslam::apps {
namespace {

/// Stands in for a network, so that filters that want one can tell their parameters.
class SegmentsNothing : public segmentation::Segmenter {
 public:
  Result segment(const segmentation::SegmenterInput& /*input*/) override { return {}; }
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labels_; }

 private:
  core::LabelSpace labels_ = core::LabelSpace::coco();
};

void printConfiguration(const std::filesystem::path& file) {
  const auto options = file.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(file);
  const auto knowledge = knowledge::KnowledgeGraph::fromFile(core::findDataFile(options.knowledge.file, options.file));
  const filters::FilterContext context{std::make_shared<masks::AsyncSegmenter>(std::make_unique<SegmentsNothing>()),
                                       std::make_shared<knowledge::KnowledgeGraph>(knowledge)};
  std::cout << pipeline::writeSlamOptions(options, filters::FilterChain(options.filters, context));
}

}  // namespace

void addConfigCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("config", "Print every option in effect with its unit, bounds and meaning");
  auto file = std::make_shared<std::filesystem::path>();
  command->add_option("FILE", *file, "configuration (YAML); without: the defaults");
  command->callback([file] { printConfiguration(*file); });
}

}  // namespace wardslam::apps
