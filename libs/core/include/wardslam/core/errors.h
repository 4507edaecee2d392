#pragma once

#include <stdexcept>

namespace wardslam::core {

/// Something the user gave cannot be used: the message is one sentence that says what is wrong, where
/// (file, line, key, frame) and what to do. Thrown at set-up; programs print it and exit with 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One frame cannot be used, but the run can go on without it: left out, counted and told once.
class FrameError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wardslam::core
