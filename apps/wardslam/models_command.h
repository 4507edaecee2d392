#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam models list|fetch|verify`: networks from their official sources; downloads only when told to.
void addModelsCommand(CLI::App& app);

}  // namespace wardslam::apps
