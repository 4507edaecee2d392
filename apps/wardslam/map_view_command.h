#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam map view`.
void addMapViewCommand(CLI::App& mapCommand);

}  // namespace wardslam::apps
