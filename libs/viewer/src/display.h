#pragma once

#include <cstdlib>

#include "wardslam/core/errors.h"

namespace wardslam::viewer {

/// Throws core::InputError where no window can be opened.
inline void requireDisplay() {
  if (std::getenv("DISPLAY") != nullptr) return;
  throw core::InputError("there is no display to open a window on (DISPLAY is not set); write pictures instead");
}

}  // namespace wardslam::viewer
