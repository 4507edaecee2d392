#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam doctor`: whether all that a run needs is there and works.
void addDoctorCommand(CLI::App& app);

}  // namespace wardslam::apps
