#pragma once

#include <iostream>
#include <nlohmann/json.hpp>

namespace wardslam::apps {

/// Prints JSON or, by `printTable`, what people read.
template <class PrintTable>
void show(bool asJson, const nlohmann::ordered_json& json, const PrintTable& printTable) {
  if (asJson) {
    std::cout << json.dump(2) << "\n";
  } else {
    printTable(std::cout);
  }
}

}  // namespace wardslam::apps
