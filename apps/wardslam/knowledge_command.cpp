#include "knowledge_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/data_files.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/viewer/graph_drawing.h"

namespace wardslam::apps {
namespace {

using knowledge::KnowledgeGraph;

struct ShowArguments {
  std::filesystem::path file;
  std::filesystem::path svg;
};

void printSet(std::ostream& out, const KnowledgeGraph& graph, const std::string& set) {
  out << set << "\n";
  for (const std::string& entity : graph.members(set)) {
    out << "  " << entity;
    const char* before = ": ";
    for (const std::string& label : graph.labels(entity)) {
      out << before << label;
      before = ", ";
    }
    out << "\n";
  }
}

void printFact(std::ostream& out, const knowledge::Fact& fact) {
  out << "  " << fact.head << " " << fact.relation << " " << fact.tail;
  if (fact.relation == knowledge::kCanBeMovedBy) {
    out << " (strength " << fact.bond.strength << ", reach " << fact.bond.reach_m << " m)";
  }
  out << "\n";
}

void print(std::ostream& out, const KnowledgeGraph& graph) {
  for (const char* set : {"moving", "movable", "static"}) {
    const auto sets = graph.sets();
    if (std::find(sets.begin(), sets.end(), set) != sets.end()) printSet(out, graph, set);
  }
  out << "facts\n";
  for (const knowledge::Fact& fact : graph.facts()) printFact(out, fact);
}

void show(const ShowArguments& arguments) {
  // A file of the user's, seen from where he is; else one that ships with the program.
  const auto file = std::filesystem::exists(arguments.file) ? arguments.file : core::findDataFile(arguments.file);
  const auto graph = KnowledgeGraph::fromFile(file);
  if (arguments.svg.empty()) {
    print(std::cout, graph);
  } else {
    core::writeFileAtomically(arguments.svg, viewer::drawSvg(graph));
  }
}

}  // namespace

void addKnowledgeCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("knowledge", "What is known before the run: who can move what");
  command->require_subcommand(1);
  CLI::App* showCommand = command->add_subcommand("show", "Print a knowledge graph, or draw it");
  auto arguments = std::make_shared<ShowArguments>();
  showCommand->add_option("FILE", arguments->file, "knowledge graph (YAML), such as knowledge/hospital.yaml")
      ->required();
  showCommand->add_option("--svg", arguments->svg, "draw it into this file instead");
  showCommand->callback([arguments] { show(*arguments); });
}

}  // namespace wardslam::apps
