#include "wardslam/reproduction/plan.h"

#include <algorithm>
#include <cctype>

#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::reproduction {
namespace {

using core::ConfigNode;

/// Names become names of folders.
void requireName(const ConfigNode& node, const std::string& name) {
  if (name.empty()) node.fail("'name' is missing");
  if (name.front() == '.' || name.find('/') != std::string::npos) {
    node.child("name").fail("'" + name + "' cannot be the name of a folder");
  }
}

template <class Item>
void requireNewName(const ConfigNode& node, const std::vector<Item>& earlier, const std::string& name) {
  requireName(node, name);
  const bool isTaken = std::any_of(earlier.begin(), earlier.end(), [&](const Item& item) { return item.name == name; });
  if (isTaken) node.child("name").fail("'" + name + "' is the name of an earlier one");
}

bool isWebAddress(const std::string& url) { return url.rfind("https://", 0) == 0 || url.rfind("http://", 0) == 0; }

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

void requireUsableArchive(const ConfigNode& node, const Archive& archive) {
  if (!node.exists()) return;
  const bool isArchive =
      endsWith(archive.url, ".tgz") || endsWith(archive.url, ".tar.gz") || endsWith(archive.url, ".zip");
  if (!isWebAddress(archive.url) || !isArchive) {
    node.fail("'url' is to begin with https:// or http:// and to end with .tgz, .tar.gz or .zip");
  }
  const bool isHex = std::all_of(archive.sha256.begin(), archive.sha256.end(),
                                 [](unsigned char c) { return std::isxdigit(c) != 0 && std::isupper(c) == 0; });
  if (!archive.sha256.empty() && (archive.sha256.size() != 64 || !isHex)) {
    node.child("sha256").fail("64 hexadecimal digits in lower case are expected here");
  }
}

Sequence readSequence(const ConfigNode& node, const std::vector<Sequence>& earlier) {
  Sequence sequence;
  core::readOptions(node, sequence);
  requireNewName(node, earlier, sequence.name);
  requireUsableArchive(node.child("fetch"), sequence.fetch);
  if (!sequence.render.empty() && !sequence.fetch.url.empty()) {
    node.child("render").fail("the sequence is to be fetched already; one of both is enough");
  }
  if (sequence.folder.empty()) sequence.folder = sequence.name;
  return sequence;
}

Variant readVariant(const ConfigNode& node, const std::vector<Variant>& earlier) {
  Variant variant;
  core::readOptions(node, variant);
  requireNewName(node, earlier, variant.name);
  if (variant.n % 2 == 0) node.child("n").fail(std::to_string(variant.n) + " is even: a key point has no middle then");
  if (variant.delta >= variant.n * variant.n) {
    (node.child("delta").exists() ? node.child("delta") : node)
        .fail("delta = " + std::to_string(variant.delta) + " can never be exceeded: the descriptor has " +
              std::to_string(variant.n * variant.n) + " cells");
  }
  if (variant.match_outliers && !variant.segments()) {
    node.child("match_outliers").fail("descriptors need what the filters 'paper' and 'on' know of classes");
  }
  return variant;
}

template <class Item, class Read>
std::vector<Item> readList(const ConfigNode& root, const char* key, Read read) {
  const ConfigNode list = root.child(key);
  if (!list.exists() || !list.yaml().IsSequence() || list.yaml().size() == 0) {
    (list.exists() ? list : root).fail("'" + std::string(key) + "' is to list at least one");
  }
  std::vector<Item> items;
  for (std::size_t i = 0; i < list.yaml().size(); ++i) items.push_back(read(list.item(i), items));
  return items;
}

}  // namespace

Plan readPlan(const std::filesystem::path& file) {
  const ConfigNode root = ConfigNode::fromFile(file);
  Plan plan;
  plan.file = file;
  core::OptionReader reader(root);
  Plan::describe(plan, reader);
  (void)reader.opaque("sequences");
  (void)reader.opaque("variants");
  reader.finish();
  plan.sequences = readList<Sequence>(root, "sequences", readSequence);
  plan.variants = readList<Variant>(root, "variants", readVariant);
  if (plan.title.empty()) plan.title = file.stem().string();
  return plan;
}

int keyPointsMore(const Plan& plan, int repetition) {
  const int steps = (repetition + 1) / 2;
  return plan.key_points_step * (repetition % 2 == 1 ? steps : -steps);
}

}  // namespace wardslam::reproduction
