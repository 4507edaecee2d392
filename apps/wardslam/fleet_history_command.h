#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam fleet history|watch`: what stood where, and what changes.
void addFleetHistoryCommands(CLI::App& fleetCommand);

}  // namespace wardslam::apps
