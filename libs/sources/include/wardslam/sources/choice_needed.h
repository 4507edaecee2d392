#pragma once

#include "wardslam/core/errors.h"

namespace wardslam::sources {

/// A recording holds several of what one is needed of, and nothing tells which is meant. The sentence lists them and
/// names the option that chooses.
class ChoiceNeeded : public core::InputError {
 public:
  using InputError::InputError;
};

}  // namespace wardslam::sources
