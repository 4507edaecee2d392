#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace wardslam::apps {

/// `wardslam map rooms`
void addMapRoomsCommand(CLI::App& mapCommand);

}  // namespace wardslam::apps
