#pragma once

#include <cstdio>
#include <exception>
#include <optional>

namespace wardslam::gates {

/// What `get` gives; nothing where it throws, with its sentence. A test that is known to fail must fail for its figures
/// alone: without them it skips, which does not count as failure.
template <class Get>
auto figuresOf(const Get& get) -> std::optional<decltype(get())> {
  try {
    return get();
  } catch (const std::exception& error) {
    std::printf("no figures: %s\n", error.what());
    return std::nullopt;
  }
}

}  // namespace wardslam::gates
