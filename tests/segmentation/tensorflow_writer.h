#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wardslam::test {

/// Just enough of TensorFlow's GraphDef to write frozen graphs of a few operations by hand. Field numbers: graph.proto,
/// node_def.proto, attr_value.proto.
class TensorFlowWriter {
 public:
  void addNode(const std::string& operation, const std::string& name, const std::vector<std::string>& inputs) {
    std::string node = bytes(1, name) + bytes(2, operation);
    for (const auto& input : inputs) node += bytes(3, input);
    const std::string floatType = number(6, 1);
    for (const char* key : {"dtype", "T"}) node += bytes(5, bytes(1, key) + bytes(2, floatType));
    graph_ += bytes(1, node);
  }

  [[nodiscard]] const std::string& graph() const { return graph_; }

 private:
  static std::string number(std::uint64_t field, std::uint64_t value) {
    return {static_cast<char>(field << 3U), static_cast<char>(value)};
  }
  static std::string bytes(std::uint64_t field, const std::string& content) {
    std::string size;  // varint
    std::uint64_t rest = content.size();
    for (; rest > 127; rest >>= 7U) size += static_cast<char>((rest & 127U) | 128U);
    return static_cast<char>((field << 3U) | 2U) + size + static_cast<char>(rest) + content;
  }

  std::string graph_;
};

}  // namespace wardslam::test
