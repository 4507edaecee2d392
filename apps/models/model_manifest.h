#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wardslam::apps {

struct Checksum {
  std::string algorithm;  ///< "sha256", "sha384", "sha512"
  std::string hex;        ///< Lower case.
};

struct ModelFile {
  std::string name;  ///< On disk; a plain name.
  std::string url;
  std::optional<std::uint64_t> size_bytes;
  std::optional<Checksum> checksum;
};

/// A network and where it officially comes from.
struct Model {
  std::string name;
  std::string title;
  std::string licence;
  std::string homepage;
  std::string use;  ///< What to do with the files.
  std::vector<ModelFile> files;
};

/// The networks somebody may want: share/models.yaml, or a list of one's own in the same form.
class ModelManifest {
 public:
  /// Throws core::InputError with file, line and key.
  [[nodiscard]] static ModelManifest fromFile(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<Model>& models() const { return models_; }

  /// Throws core::InputError with the nearest name when there is none of that name.
  [[nodiscard]] const Model& find(const std::string& name) const;
  [[nodiscard]] bool contains(const std::string& name) const;

  /// By its name on disk; null when no network has such a file.
  [[nodiscard]] const ModelFile* findFile(const std::string& fileName) const;

 private:
  std::filesystem::path file_;
  std::vector<Model> models_;
};

}  // namespace wardslam::apps
