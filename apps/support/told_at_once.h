#pragma once

#include <string>

namespace wardslam::apps {

/// Tells the user now, on standard error and over the progress line that may be there. Any thread may.
void tellAtOnce(const std::string& sentence);

}  // namespace wardslam::apps
