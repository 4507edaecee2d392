#include "models/model_manifest.h"

#include <algorithm>
#include <cctype>
#include <limits>

#include "wardslam/core/digest.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/core/options.h"

namespace wardslam::apps {
namespace {

using core::ConfigNode;

constexpr const char* kChecksums[] = {"sha256", "sha384", "sha512"};

std::string text(const ConfigNode& parent, const char* key) {
  const ConfigNode node = parent.child(key);
  if (!node.exists()) parent.fail(std::string("'") + key + "' is missing");
  if (!node.yaml().IsScalar() || node.yaml().Scalar().empty()) node.fail("text is expected here");
  return node.yaml().Scalar();
}

std::optional<Checksum> readChecksum(const ConfigNode& node) {
  std::optional<Checksum> checksum;
  for (const char* algorithm : kChecksums) {
    const ConfigNode value = node.child(algorithm);
    if (!value.exists()) continue;
    if (checksum) value.fail("one checksum is enough");
    const std::string hex = text(node, algorithm);
    const bool isHex = std::all_of(hex.begin(), hex.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
    if (!isHex || hex.size() != core::digestLength(algorithm)) {
      value.fail(std::to_string(core::digestLength(algorithm)) + " hexadecimal digits are expected here");
    }
    checksum = Checksum{algorithm, hex};
    std::transform(hex.begin(), hex.end(), checksum->hex.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  }
  return checksum;
}

std::optional<std::uint64_t> readSize(const ConfigNode& node) {
  if (!node.exists()) return std::nullopt;
  std::uint64_t size = 0;
  if (!node.yaml().IsScalar() || !YAML::convert<std::uint64_t>::decode(node.yaml(), size) || size == 0) {
    node.fail("a number of bytes is expected here");
  }
  return size;
}

ModelFile readFile(const ConfigNode& node) {
  node.requireKeys({"url", "name", "size", "sha256", "sha384", "sha512"});
  ModelFile file;
  file.url = text(node, "url");
  const bool isWeb = file.url.rfind("https://", 0) == 0 || file.url.rfind("http://", 0) == 0;
  if (!isWeb) node.child("url").fail("an address that begins with https:// or http:// is expected here");
  file.name = node.child("name").exists() ? text(node, "name") : file.url.substr(file.url.rfind('/') + 1);
  if (file.name.empty() || file.name.front() == '.' || file.name.find('/') != std::string::npos) {
    node.fail("'" + file.name + "' cannot be the name of the file; give one under 'name'");
  }
  file.size_bytes = readSize(node.child("size"));
  file.checksum = readChecksum(node);
  return file;
}

Model readModel(const std::string& name, const ConfigNode& node) {
  node.requireKeys({"title", "licence", "homepage", "use", "files"});
  Model model{name, text(node, "title"), text(node, "licence"), text(node, "homepage"), text(node, "use"), {}};
  const ConfigNode files = node.child("files");
  if (!files.exists() || !files.yaml().IsSequence() || files.yaml().size() == 0) {
    node.fail("'files' is to list at least one file");
  }
  for (std::size_t i = 0; i < files.yaml().size(); ++i) model.files.push_back(readFile(files.item(i)));
  return model;
}

}  // namespace

ModelManifest ModelManifest::fromFile(const std::filesystem::path& file) {
  const ConfigNode root = ConfigNode::fromFile(file);
  root.requireKeys({"models"});
  const ConfigNode models = root.child("models");
  if (!models.exists() || !models.yaml().IsMap()) root.fail("a mapping 'models' is expected here");
  ModelManifest manifest;
  manifest.file_ = file;
  for (const auto& entry : models.yaml()) {
    const ConfigNode node(entry.second, file, models.key() + "." + entry.first.Scalar());
    if (manifest.contains(entry.first.Scalar())) node.fail("this name is given twice");
    manifest.models_.push_back(readModel(entry.first.Scalar(), node));
  }
  return manifest;
}

bool ModelManifest::contains(const std::string& name) const {
  return std::any_of(models_.begin(), models_.end(), [&](const Model& model) { return model.name == name; });
}

const Model& ModelManifest::find(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& model : models_) {
    if (model.name == name) return model;
    names.push_back(model.name);
  }
  throw core::InputError("'" + name + "' is not in " + file_.string() +
                         (names.empty() ? "" : "; did you mean '" + core::nearestName(name, names) + "'?") +
                         " `wardslam models list` shows all");
}

const ModelFile* ModelManifest::findFile(const std::string& fileName) const {
  for (const auto& model : models_) {
    for (const auto& file : model.files) {
      if (file.name == fileName) return &file;
    }
  }
  return nullptr;
}

}  // namespace wardslam::apps
