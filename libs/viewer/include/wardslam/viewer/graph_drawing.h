#pragma once

#include <string>

namespace wardslam::knowledge {
class KnowledgeGraph;
}

namespace wardslam::viewer {

/// The graph as a picture (SVG, self-contained). On the left what moves by itself and, below, what is static; on the
/// right what can be moved, in the frames of its sets. A line joins a thing (or set) to who can move it: the thicker
/// the likelier, labelled with strength and reach; other relations are dashed.
[[nodiscard]] std::string drawSvg(const knowledge::KnowledgeGraph& graph);

}  // namespace wardslam::viewer
