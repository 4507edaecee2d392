#pragma once

namespace CLI {
class App;
}

namespace wardslam::apps {

/// `wardslam eval-objects TRUTH.csv OBJECTS.json --trajectory T --ground-truth G`
void addEvalObjectsCommand(CLI::App& app);

}  // namespace wardslam::apps
