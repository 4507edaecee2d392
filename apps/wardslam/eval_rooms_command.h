#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam eval-rooms`.
void addEvalRoomsCommand(CLI::App& app);

}  // namespace wardslam::apps
