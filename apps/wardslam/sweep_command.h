#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam sweep INPUT --param NAME=A,B,… --out DIR`
void addSweepCommand(CLI::App& app);

}  // namespace wardslam::apps
