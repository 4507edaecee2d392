#pragma once

namespace CLI {
class App;
}

namespace wardslam::apps {

/// `wardslam eval-floor TRUTH.yaml MAP.wardmap --trajectory T --ground-truth G`
void addEvalFloorCommand(CLI::App& app);

}  // namespace wardslam::apps
