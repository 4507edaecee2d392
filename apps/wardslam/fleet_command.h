#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam fleet`: the hospital's database.
void addFleetCommand(CLI::App& app);

}  // namespace wardslam::apps
