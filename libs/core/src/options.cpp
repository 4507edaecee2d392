#include "wardslam/core/options.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::core {
namespace {

template <class T>
std::string toText(T value) {
  std::ostringstream text;
  text.precision(10);
  text << value;
  return text.str();
}

/// As short as toText() where that reads back to the same value, with all digits elsewhere.
std::string toExactText(double value) {
  std::string text = toText(value);
  if (std::strtod(text.c_str(), nullptr) == value) return text;
  std::ostringstream exact;
  exact.precision(std::numeric_limits<double>::max_digits10);
  exact << value;
  return exact.str();
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

template <class T>
std::string describeBounds(Bounds<T> bounds, const std::string& unit) {
  return "[" + toText(bounds.min) + ", " + toText(bounds.max) + "]" + (unit.empty() ? "" : " " + unit);
}

std::string quoted(const std::string& value) {
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << value;
  return emitter.c_str();
}

}  // namespace

ConfigNode::ConfigNode(const YAML::Node& node, std::filesystem::path file, std::string key)
    : node_(node), file_(std::move(file)), key_(std::move(key)) {}

ConfigNode ConfigNode::fromFile(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) throw InputError(file.string() + ": is a folder; a YAML file is expected");
  try {
    return {YAML::LoadFile(file.string()), file};
  } catch (const YAML::BadFile&) {
    throw InputError(file.string() + ": cannot be opened for reading");
  } catch (const YAML::ParserException& error) {
    throw InputError(file.string() + ":" + std::to_string(error.mark.line + 1) + ": not valid YAML: " + error.msg);
  }
}

ConfigNode ConfigNode::fromText(const std::string& text, const std::filesystem::path& name) {
  try {
    return {YAML::Load(text), name};
  } catch (const YAML::ParserException& error) {
    throw InputError(name.string() + ":" + std::to_string(error.mark.line + 1) + ": not valid YAML: " + error.msg);
  }
}

ConfigNode ConfigNode::child(const std::string& key) const {
  const std::string path = key_.empty() ? key : key_ + "." + key;
  if (!exists()) return {YAML::Node(), file_, path};
  if (!node_.IsMap()) fail("a mapping (key: value) is expected here");
  const YAML::Node& constNode = node_;
  const YAML::Node value = constNode[key];
  return {value.IsDefined() ? value : YAML::Node(), file_, path};
}

ConfigNode ConfigNode::item(std::size_t index) const {
  if (!node_.IsSequence() || index >= node_.size())
    fail("a list with at least " + toText(index + 1) + " items is expected here");
  return {node_[index], file_, key_ + "[" + std::to_string(index) + "]"};
}

void ConfigNode::fail(const std::string& what) const {
  std::string where = file_.string();
  if (exists() && !node_.Mark().is_null()) where += ":" + std::to_string(node_.Mark().line + 1);
  throw InputError(where + ": " + (key_.empty() ? "" : "'" + key_ + "': ") + what);
}

void ConfigNode::requireKeys(const std::vector<std::string>& known) const {
  if (!exists()) return;
  if (!node_.IsMap()) fail("a mapping (key: value) is expected here");
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) ConfigNode(entry.first, file_, key_).fail("a plain name is expected as key");
    const std::string& key = entry.first.Scalar();
    const ConfigNode named(entry.first, file_, key_.empty() ? key : key_ + "." + key);
    if (!seen.insert(key).second) named.fail("this key is given twice");
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string nearest = nearestName(key, known);
    named.fail("unknown key" + (nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?"));
  }
}

template <class T>
void OptionReader::scalar(const char* key, T& value, const char* expected) {
  known_.emplace_back(key);
  const ConfigNode node = node_.child(key);
  if (!node.exists()) return;
  if (!node.yaml().IsScalar() || !YAML::convert<T>::decode(node.yaml(), value)) {
    node.fail(std::string(expected) + " is expected here");
  }
}

void OptionReader::operator()(const char* key, int& value, Bounds<int> bounds, const char* unit, const char*) {
  scalar(key, value, "a whole number");
  if (value < bounds.min || value > bounds.max) {
    node_.child(key).fail(toText(value) + " is outside " + describeBounds(bounds, unit));
  }
}

void OptionReader::operator()(const char* key, double& value, Bounds<double> bounds, const char* unit, const char*) {
  scalar(key, value, "a number");
  if (!(value >= bounds.min && value <= bounds.max)) {
    node_.child(key).fail(toText(value) + " is outside " + describeBounds(bounds, unit));
  }
}

void OptionReader::operator()(const char* key, bool& value, const char*) { scalar(key, value, "true or false"); }

void OptionReader::operator()(const char* key, std::string& value, const char*) { scalar(key, value, "a text"); }

ConfigNode OptionReader::opaque(const char* key) {
  known_.emplace_back(key);
  return node_.child(key);
}

void OptionReader::choice(const char* key, int& index, const std::vector<std::string>& names, const char*) {
  std::string name = names.at(static_cast<std::size_t>(index));
  scalar(key, name, "a name");
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) node_.child(key).fail("'" + name + "' is none of: " + joined(names));
  index = static_cast<int>(found - names.begin());
}

void OptionWriter::operator()(const char* key, const int& value, Bounds<int> bounds, const char* unit,
                              const char* help) {
  line(key, toText(value), describeBounds(bounds, unit) + " " + help);
}

void OptionWriter::operator()(const char* key, const double& value, Bounds<double> bounds, const char* unit,
                              const char* help) {
  line(key, toExactText(value), describeBounds(bounds, unit) + " " + help);
}

void OptionWriter::operator()(const char* key, const bool& value, const char* help) {
  line(key, value ? "true" : "false", std::string("true, false: ") + help);
}

void OptionWriter::operator()(const char* key, const std::string& value, const char* help) {
  line(key, quoted(value), help);
}

void OptionWriter::choice(const char* key, int index, const std::vector<std::string>& names, const char* help) {
  line(key, names.at(static_cast<std::size_t>(index)), joined(names) + ": " + help);
}

void OptionWriter::block(const char* key, const std::string& indentedText) {
  text_ += std::string(2 * static_cast<std::size_t>(indent_), ' ') + key + ":\n" + indentedText;
}

void OptionWriter::line(const std::string& key, const std::string& value, const std::string& comment) {
  text_ += std::string(2 * static_cast<std::size_t>(indent_), ' ') + key + ": " + value + "  # " + comment + "\n";
}

}  // namespace wardslam::core
