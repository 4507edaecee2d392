#pragma once

namespace CLI {
class App;
}

namespace wardslam::apps {

/// `wardslam run INPUT --out DIR …`: tracks a recording; trajectory, summary and configuration go to DIR.
void addRunCommand(CLI::App& app);

}  // namespace wardslam::apps
