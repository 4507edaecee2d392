#pragma once

#include <string>

namespace wardslam::core {

/// Text as it may stand in HTML, SVG and XML, between tags and in quoted attributes.
[[nodiscard]] std::string escapedForMarkup(const std::string& text);

}  // namespace wardslam::core
