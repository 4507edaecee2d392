#include "wardslam/filters/filter_chain.h"

#include <mrpt/system/os.h>

#include <filesystem>
#include <sstream>

#include "wardslam/core/nearest_name.h"
#include "wardslam/filters/register_filters.h"

namespace wardslam::filters {
namespace {

std::vector<std::string> registeredFilters() {
  std::vector<std::string> names;
  for (const auto* type : mrpt::rtti::getAllRegisteredClassesChildrenOf(CLASS_ID(ObservationFilter))) {
    if (type->ptrCreateObject) names.emplace_back(type->className);
  }
  return names;
}

std::string textOf(const core::ConfigNode& node) {
  if (!node.exists() || !node.yaml().IsScalar()) node.fail("a text is expected here");
  return node.yaml().as<std::string>();
}

/// Returns the plug-in's path as written; empty when the item names none.
std::string loadPlugin(const core::ConfigNode& item) {
  const core::ConfigNode node = item.child("plugin");
  if (!node.exists()) return {};
  std::string written = textOf(node);
  const auto file = std::filesystem::absolute(node.file().parent_path() / written);  // an absolute path stays itself
  if (!std::filesystem::exists(file)) node.fail("there is no plug-in " + file.string());
  std::string trouble;
  if (!mrpt::system::loadPluginModule(file.string(), trouble)) {
    node.fail("plug-in " + file.string() + " cannot be loaded: " + trouble);
  }
  return written;
}

ObservationFilter::Ptr makeFilter(const core::ConfigNode& item) {
  const core::ConfigNode node = item.child("class_name");
  const std::string name = textOf(node);
  const auto* type = mrpt::rtti::findRegisteredClass(name);
  if (type == nullptr) {
    node.fail("no filter '" + name + "' is registered; did you mean '" + core::nearestName(name, registeredFilters()) +
              "', or is its 'plugin' missing?");
  }
  if (!type->derivedFrom(CLASS_ID(ObservationFilter)) || !type->ptrCreateObject) {
    node.fail("'" + name + "' is no observation filter");
  }
  return std::dynamic_pointer_cast<ObservationFilter>(mrpt::rtti::classFactory(type->className));
}

}  // namespace

FilterChain::FilterChain(const core::ConfigNode& list, const FilterContext& context) {
  if (!list.exists()) return;
  if (!list.yaml().IsSequence()) list.fail("a list of filters (- class_name: …) is expected here");
  registerAllFilters();
  for (std::size_t i = 0; i < list.yaml().size(); ++i) {
    const core::ConfigNode item = list.item(i);
    item.requireKeys({"class_name", "params", "plugin"});
    Link link;
    link.plugin = loadPlugin(item);
    link.filter = makeFilter(item);
    link.filter->initialize(item.child("params"), context);
    links_.push_back(std::move(link));
  }
}

void FilterChain::begin(const core::Frame& frame) {
  for (const Link& link : links_) link.filter->begin(frame);
}

void FilterChain::apply(core::Frame& frame) {
  for (const Link& link : links_) link.filter->apply(frame);
}

void FilterChain::end(const core::Frame& frame, const std::optional<Eigen::Isometry3d>& T_map_cam) {
  for (const Link& link : links_) link.filter->end(frame, T_map_cam);
}

std::string FilterChain::parameters(int indent) const {
  const std::string margin(2 * static_cast<std::size_t>(indent), ' ');
  std::ostringstream text;
  for (const Link& link : links_) {
    const std::string parameters = link.filter->parameters(indent + 2);
    text << margin << "- class_name: " << link.filter->GetRuntimeClass()->className << "\n";
    if (!link.plugin.empty()) text << margin << "  plugin: '" << link.plugin << "'\n";
    text << margin << "  params:" << (parameters.empty() ? " {}\n" : "\n" + parameters);
  }
  return text.str();
}

}  // namespace wardslam::filters
