#pragma once

namespace CLI {
class App;
}

namespace wardslam::apps {

/// `wardslam config [FILE]`: every option in effect, with unit, bounds and meaning.
void addConfigCommand(CLI::App& app);

}  // namespace wardslam::apps
