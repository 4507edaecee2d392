#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam eval GROUNDTRUTH TRAJECTORY [--json]`: the errors of a trajectory against the truth, on standard output.
void addEvalCommand(CLI::App& app);

}  // namespace wardslam::apps
