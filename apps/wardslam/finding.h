#pragma once

#include <string>
#include <vector>

namespace wardslam::apps {

/// What was found out about one thing that a run needs.
struct Finding {
  enum class Kind { Good, Note, Trouble };  ///< A note is worth knowing; trouble would fail a run.
  Kind kind = Kind::Good;
  std::string subject;  ///< "disk"
  std::string text;     ///< "12.3 GB free, writes 240 MB/s"
};
using Findings = std::vector<Finding>;

}  // namespace wardslam::apps
