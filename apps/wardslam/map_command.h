#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam map info|objects|nearest|at|zones|diff|check|export FILE`: what a saved map knows.
void addMapCommand(CLI::App& app);

}  // namespace wardslam::apps
