#include "support/program.h"

#include <exception>
#include <iostream>

namespace wardslam::apps {

int runProgram(const std::string& name, const std::function<int()>& body) {
  try {
    return body();
  } catch (const UsageError& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return kWrongUsage;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return kFailure;
  }
}

}  // namespace wardslam::apps
