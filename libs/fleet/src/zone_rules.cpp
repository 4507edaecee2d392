#include "zone_rules.h"

namespace wardslam::fleet {

nlohmann::json ruleOf(const mapping::Zone& zone) {
  return {{"type", mapping::toString(zone.type)}, {"max_speed_mps", zone.maxSpeed_mps},
          {"direction_rad", zone.direction_rad},  {"entry", zone.actions.entry},
          {"inside", zone.actions.inside},        {"exit", zone.actions.exit}};
}

void takeRule(const nlohmann::json& rule, mapping::Zone& zone) {
  zone.type = mapping::zoneTypeFrom(rule.at("type")).value_or(mapping::ZoneType::Place);
  zone.maxSpeed_mps = rule.at("max_speed_mps");
  zone.direction_rad = rule.at("direction_rad");
  zone.actions.entry = rule.at("entry").get<std::vector<std::string>>();
  zone.actions.inside = rule.at("inside").get<std::vector<std::string>>();
  zone.actions.exit = rule.at("exit").get<std::vector<std::string>>();
}

}  // namespace wardslam::fleet
