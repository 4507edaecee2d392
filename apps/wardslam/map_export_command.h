#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam map export FILE --ply F …`, to be added to the `map` command.
void addMapExportCommand(CLI::App& mapCommand);

}  // namespace wardslam::apps
