#include "fuzz_input.h"
#include "wardslam/core/label_space.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/zones.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/segmentation/label_map.h"

// Whatever is configured in YAML: the same text as configuration, knowledge, zones and labels, and as a list of
// classes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto file = fuzz::scratch().write("settings.yaml", data, size);
  fuzz::mayRefuse([&] { (void)pipeline::readSlamOptions(file); });
  fuzz::mayRefuse([&] {
    const auto graph = knowledge::KnowledgeGraph::fromFile(file);
    (void)knowledge::MotionRules(graph, core::LabelSpace::coco());
  });
  fuzz::mayRefuse([&] { (void)mapping::Zones::fromFile(file).at({0.0, 0.0}); });
  fuzz::mayRefuse([&] { (void)segmentation::LabelMap::fromFile(file); });
  fuzz::mayRefuse([&] { (void)core::LabelSpace::cocoWith(file); });
  (void)pipeline::withoutFolders(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
