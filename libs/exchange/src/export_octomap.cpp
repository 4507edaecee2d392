#include <ostream>

#include "octree.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

/// As OcTree::writeBinary(), which cannot keep from talking to standard error.
void writeBinary(octomap::OcTree& tree, std::ostream& out) {
  tree.toMaxLikelihood();
  tree.prune();
  out << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
      << "id " << tree.getTreeType() << "\nsize " << tree.size() << "\nres " << tree.getResolution() << "\ndata\n";
  tree.writeBinaryData(out);
}

}  // namespace

void exportOctomap(const mapping::SemanticMap& map, const std::filesystem::path& file, double resolution_m) {
  const bool withProbabilities = file.extension() == ".ot";
  if (!withProbabilities && file.extension() != ".bt") {
    throw core::InputError(file.string() + ": an OctoMap is a .bt file, or with probabilities a .ot file");
  }
  octomap::OcTree tree(resolution_m);
  fillOctree(map, tree);
  core::AtomicFile out(file);
  if (withProbabilities) {
    tree.write(out.stream());
  } else {
    writeBinary(tree, out.stream());
  }
  out.commit();
}

}  // namespace wardslam::exchange
