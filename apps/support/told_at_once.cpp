#include "support/told_at_once.h"

#include <iostream>

#include "support/progress.h"

namespace wardslam::apps {

void tellAtOnce(const std::string& sentence) {
  const std::string overProgressLine = standardErrorIsTerminal() ? "\r\033[K" : "";
  std::cerr << overProgressLine + "wardslam: " + sentence + "\n" << std::flush;  // in one piece
}

}  // namespace wardslam::apps
