#pragma once

namespace CLI {
class App;
}

namespace wardslam::apps {

/// `wardslam knowledge show FILE [--svg OUT]`: what a knowledge graph says, as text or as a picture.
void addKnowledgeCommand(CLI::App& app);

}  // namespace wardslam::apps
