#pragma once

#include <string>

#include "wardslam/core/errors.h"

namespace wardslam::test {

/// What `act` says is wrong with its input (the message of its core::InputError); empty when nothing is.
template <class Act>
std::string complaintOf(Act&& act) {
  try {
    static_cast<void>(act());
  } catch (const core::InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace wardslam::test
