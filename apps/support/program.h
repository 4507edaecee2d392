#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace wardslam::apps {

enum ExitCode : int { kSuccess = 0, kFailure = 1, kWrongUsage = 2 };

/// Wrong combination of arguments: printed like an InputError, but the program ends with kWrongUsage.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a program's body: every exception becomes one sentence on standard error ("<name>: …") and an exit code.
int runProgram(const std::string& name, const std::function<int()>& body);

}  // namespace wardslam::apps
