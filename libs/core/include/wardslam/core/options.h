#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

/// Options from YAML, declared once.
///
/// A struct of options gives each field its default and describes it in one place:
///
///     struct OrbOptions {
///       int key_points = 1000;
///       template <class Self, class Visitor>
///       static void describe(Self& self, Visitor& visit) {
///         visit("key_points", self.key_points, {100, 20000}, "count", "how many ORB key points per image");
///       }
///     };
///
/// The same description reads the YAML (an unknown key is an error that names file, line and the nearest valid key;
/// so is a value of the wrong type or out of bounds) and writes it back with unit, bounds and help as comments.
namespace wardslam::core {

/// Closed interval of allowed values.
template <class T>
struct Bounds {
  T min;
  T max;
};

/// A YAML mapping and where it comes from, for error messages.
class ConfigNode {
 public:
  /// An empty mapping: every option keeps its default.
  ConfigNode() = default;
  ConfigNode(const YAML::Node& node, std::filesystem::path file, std::string key = {});

  /// Throw InputError naming the file, and the line where it is not YAML.
  [[nodiscard]] static ConfigNode fromFile(const std::filesystem::path& file);
  [[nodiscard]] static ConfigNode fromText(const std::string& text, const std::filesystem::path& name = "<text>");

  [[nodiscard]] const YAML::Node& yaml() const { return node_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const std::string& key() const { return key_; }  ///< Dotted path from the root; empty at the root.

  /// The value at `key`; a null node where it is absent.
  [[nodiscard]] ConfigNode child(const std::string& key) const;
  [[nodiscard]] ConfigNode item(std::size_t index) const;  ///< Of a sequence.
  [[nodiscard]] bool exists() const { return node_.IsDefined() && !node_.IsNull(); }

  /// Throws InputError: "<file>:<line>: <key>: <what>".
  [[noreturn]] void fail(const std::string& what) const;

  /// Throws unless this is a mapping (or nothing) whose keys are all in `known`, each given once;
  /// names the nearest known key.
  void requireKeys(const std::vector<std::string>& known) const;

 private:
  YAML::Node node_;
  std::filesystem::path file_ = "<defaults>";
  std::string key_;
};

/// Visitor that fills options from a ConfigNode. Used through readOptions().
class OptionReader {
 public:
  explicit OptionReader(ConfigNode node) : node_(std::move(node)) {}

  void operator()(const char* key, int& value, Bounds<int> bounds, const char* unit, const char* help);
  void operator()(const char* key, double& value, Bounds<double> bounds, const char* unit, const char* help);
  void operator()(const char* key, bool& value, const char* help);
  void operator()(const char* key, std::string& value, const char* help);

  /// An enumeration given by name: names[i] stands for the value i.
  template <class Enum, class = std::enable_if_t<std::is_enum_v<Enum>>>
  void operator()(const char* key, Enum& value, const std::vector<std::string>& names, const char* help) {
    int index = static_cast<int>(value);
    choice(key, index, names, help);
    value = static_cast<Enum>(index);
  }

  /// A nested struct of options.
  template <class Options>
  void group(const char* key, Options& options) {
    known_.emplace_back(key);
    OptionReader reader(node_.child(key));
    Options::describe(options, reader);
    reader.finish();
  }

  /// A part of the file that somebody else reads (filter parameters).
  ConfigNode opaque(const char* key);

  /// Throws on keys nobody asked for.
  void finish() const { node_.requireKeys(known_); }

 private:
  void choice(const char* key, int& index, const std::vector<std::string>& names, const char* help);
  template <class T>
  void scalar(const char* key, T& value, const char* expected);

  ConfigNode node_;
  std::vector<std::string> known_;
};

/// Visitor that writes options as commented YAML. Used through writeOptions().
class OptionWriter {
 public:
  explicit OptionWriter(int indent = 0) : indent_(indent) {}

  void operator()(const char* key, const int& value, Bounds<int> bounds, const char* unit, const char* help);
  void operator()(const char* key, const double& value, Bounds<double> bounds, const char* unit, const char* help);
  void operator()(const char* key, const bool& value, const char* help);
  void operator()(const char* key, const std::string& value, const char* help);
  template <class Enum, class = std::enable_if_t<std::is_enum_v<Enum>>>
  void operator()(const char* key, const Enum& value, const std::vector<std::string>& names, const char* help) {
    choice(key, static_cast<int>(value), names, help);
  }
  template <class Options>
  void group(const char* key, const Options& options) {
    OptionWriter nested(indent_ + 1);
    Options::describe(options, nested);
    block(key, nested.text());
  }

  /// A mapping already written with indent() + 1.
  void block(const char* key, const std::string& indentedText);
  [[nodiscard]] int indent() const { return indent_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void choice(const char* key, int index, const std::vector<std::string>& names, const char* help);
  void line(const std::string& key, const std::string& value, const std::string& comment);

  int indent_;
  std::string text_;
};

/// Overwrites those options the node names; the others keep their value. Throws InputError.
template <class Options>
void readOptions(const ConfigNode& node, Options& options) {
  OptionReader reader(node);
  Options::describe(options, reader);
  reader.finish();
}

/// The options as YAML, one per line, with unit, bounds and help as comment.
template <class Options>
[[nodiscard]] std::string writeOptions(const Options& options, int indent = 0) {
  OptionWriter writer(indent);
  Options::describe(options, writer);
  return writer.text();
}

}  // namespace wardslam::core
