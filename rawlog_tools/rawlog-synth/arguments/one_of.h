#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace wardslam::synth {

/// For CLI::Option::transform(): an enumerator by its name. The help lists the names in that order, as it does those of
/// texts, and not their numbers.
template <class Enum>
[[nodiscard]] CLI::Validator oneOf(const std::vector<std::pair<std::string, Enum>>& values) {
  std::string names;
  for (const auto& [name, value] : values) names += (names.empty() ? "" : ",") + name;
  return {[values, names](std::string& text) -> std::string {
            for (const auto& [name, value] : values) {
              if (text != name) continue;
              text = std::to_string(static_cast<int>(value));
              return {};
            }
            return text + " not in {" + names + "}";
          },
          "{" + names + "}", ""};
}

}  // namespace wardslam::synth
