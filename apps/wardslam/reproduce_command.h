#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam reproduce PLAN.yaml --data DIR --out DIR`
void addReproduceCommand(CLI::App& app);

}  // namespace wardslam::apps
