#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace wardslam::synth {

/// CLI::Range that takes "nan" for no number.
[[nodiscard]] inline CLI::Validator within(double least, double most) {
  CLI::Validator range =
      CLI::Range(least, most) & CLI::Validator(
                                    [](std::string& text) -> std::string {
                                      double value = 0.0;
                                      const bool isNumber = CLI::detail::lexical_cast(text, value);
                                      return isNumber && !std::isnan(value) ? "" : text + " is no number";
                                    },
                                    "");
  return range.description(CLI::Range(least, most).get_description());
}

}  // namespace wardslam::synth
