#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace wardslam::test {

/// Just enough of ONNX's protobuf format to write networks of a few operations by hand. Field numbers: onnx.proto.
class OnnxWriter {
 public:
  enum class ElementType : std::uint64_t { Float = 1, Int64 = 7, Float16 = 10 };  // TensorProto.DataType

  /// A dimension of 0 is left open.
  void addInput(const std::string& name, const std::vector<std::uint64_t>& shape,
                ElementType type = ElementType::Float) {
    graph_ += bytes(11, valueInfo(name, shape, type));
  }
  void addMetadata(const std::string& key, const std::string& value) {
    metadata_ += bytes(14, bytes(1, key) + bytes(2, value));
  }
  void addOutput(const std::string& name, ElementType type = ElementType::Float) {
    graph_ += bytes(12, valueInfo(name, {}, type));
  }

  void addConstant(const std::string& name, const std::vector<std::uint64_t>& shape, const std::vector<float>& values) {
    std::string tensor;
    for (const auto size : shape) tensor += number(1, size);
    tensor += number(2, kFloat) + bytes(8, name);
    tensor += bytes(9, std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
    graph_ += bytes(5, tensor);
  }

  void addShape(const std::string& name, const std::vector<std::uint64_t>& sizes) {
    std::string tensor = number(1, sizes.size()) + number(2, static_cast<std::uint64_t>(ElementType::Int64));
    tensor += bytes(8, name);
    tensor += bytes(9, std::string(reinterpret_cast<const char*>(sizes.data()), sizes.size() * sizeof(std::uint64_t)));
    graph_ += bytes(5, tensor);
  }

  using Attributes = std::vector<std::pair<std::string, std::uint64_t>>;
  using ListAttributes = std::vector<std::pair<std::string, std::vector<std::uint64_t>>>;

  void addNode(const std::string& operation, const std::string& name, const std::vector<std::string>& inputs,
               const std::string& output, const Attributes& attributes = {}, const ListAttributes& lists = {}) {
    std::string node;
    for (const auto& input : inputs) node += bytes(1, input);
    node += bytes(2, output) + bytes(3, name) + bytes(4, operation);
    for (const auto& [key, value] : attributes) node += bytes(5, bytes(1, key) + number(3, value) + number(20, kInt));
    for (const auto& [key, values] : lists) {
      std::string attribute = bytes(1, key);
      for (const std::uint64_t value : values) attribute += number(8, value);
      node += bytes(5, attribute + number(20, kInts));
    }
    graph_ += bytes(1, node);
  }

  /// An output of these values, whatever the image `input` shows. cv::dnn has no outputs that depend on no input.
  void addFixedOutput(const std::string& name, const std::string& input, const std::vector<std::uint64_t>& shape,
                      const std::vector<float>& values) {
    addNode("GlobalAveragePool", name + "_pool", {input}, name + "_mean");
    addConstant(name + "_weights", {values.size(), 3, 1, 1}, std::vector<float>(values.size() * 3, 0.0F));
    addConstant(name + "_values", {values.size()}, values);
    addNode("Conv", name + "_conv", {name + "_mean", name + "_weights", name + "_values"}, name + "_row", {},
            {{"kernel_shape", {1, 1}}});
    addShape(name + "_shape", shape);
    addNode("Reshape", name + "_reshape", {name + "_row", name + "_shape"}, name);
    addOutput(name);
  }

  /// The file: IR version 7, operator set 12.
  [[nodiscard]] std::string model() const {
    return number(1, 7) + bytes(7, graph_ + bytes(2, "graph")) + bytes(8, number(2, 12)) + metadata_;
  }

 private:
  static constexpr auto kFloat = static_cast<std::uint64_t>(ElementType::Float);
  static constexpr std::uint64_t kInt = 2;  // AttributeProto.AttributeType
  static constexpr std::uint64_t kInts = 7;

  static std::string varint(std::uint64_t value) {
    std::string text;
    for (; value > 127; value >>= 7U) text += static_cast<char>((value & 127U) | 128U);
    return text + static_cast<char>(value);
  }
  static std::string number(std::uint64_t field, std::uint64_t value) { return varint(field << 3U) + varint(value); }
  static std::string bytes(std::uint64_t field, const std::string& content) {
    return varint((field << 3U) | 2U) + varint(content.size()) + content;
  }
  static std::string valueInfo(const std::string& name, const std::vector<std::uint64_t>& shape,
                               ElementType type = ElementType::Float) {
    std::string dimensions;
    for (const auto size : shape) dimensions += bytes(1, size > 0 ? number(1, size) : bytes(2, "open"));
    return bytes(1, name) + bytes(2, bytes(1, number(1, static_cast<std::uint64_t>(type)) + bytes(2, dimensions)));
  }

  std::string graph_;
  std::string metadata_;
};

}  // namespace wardslam::test
