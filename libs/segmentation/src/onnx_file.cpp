#include "onnx_file.h"

namespace wardslam::segmentation {
namespace {

/// One field of a protobuf message: a number, or bytes (text, or a message in turn).
struct Field {
  std::uint64_t number = 0;
  std::uint64_t value = 0;
  std::string_view bytes;
};

class MessageReader {
 public:
  explicit MessageReader(std::string_view message) : rest_(message) {}

  /// Empty at the end, and where the message is damaged.
  std::optional<Field> next() {
    const auto tag = rest_.empty() ? std::nullopt : varint();
    if (!tag) return std::nullopt;
    Field field;
    field.number = *tag >> 3U;
    switch (*tag & 7U) {
      case 0:
        if (const auto value = varint()) return field.value = *value, field;
        return std::nullopt;
      case 1:
        return take(field, 8);
      case 2:
        if (const auto length = varint()) return take(field, *length);
        return std::nullopt;
      case 5:
        return take(field, 4);
      default:
        return std::nullopt;
    }
  }

 private:
  std::optional<std::uint64_t> varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !rest_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(rest_.front());
      rest_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if ((byte & 0x80U) == 0) return value;
    }
    return std::nullopt;
  }

  std::optional<Field> take(Field field, std::uint64_t length) {
    if (length > rest_.size()) return std::nullopt;
    field.bytes = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return field;
  }

  std::string_view rest_;
};

std::string_view child(std::string_view message, std::uint64_t number) {
  MessageReader reader(message);
  while (const auto field = reader.next()) {
    if (field->number == number) return field->bytes;
  }
  return {};
}

std::vector<std::int64_t> shapeOf(std::string_view valueInfo) {
  constexpr std::uint64_t kType = 2, kTensorType = 1, kShape = 2, kDimension = 1, kDimensionValue = 1;
  std::vector<std::int64_t> shape;
  MessageReader dimensions(child(child(child(valueInfo, kType), kTensorType), kShape));
  while (const auto dimension = dimensions.next()) {
    if (dimension->number != kDimension) continue;
    shape.push_back(0);
    MessageReader values(dimension->bytes);
    while (const auto value = values.next()) {
      if (value->number == kDimensionValue) shape.back() = static_cast<std::int64_t>(value->value);
    }
  }
  return shape;
}

constexpr std::uint64_t kGraph = 7;

}  // namespace

std::optional<std::vector<std::int64_t>> onnxImageInput(std::string_view bytes, int channels) {
  constexpr std::uint64_t kInput = 11;
  MessageReader graph(child(bytes, kGraph));
  while (const auto field = graph.next()) {
    if (field->number != kInput) continue;
    auto shape = shapeOf(field->bytes);
    // Old files list the weights among the inputs; an image has three channels and is one of a batch.
    if (shape.size() == 4 && shape[0] <= 1 && (shape[1] == channels || shape[1] == 0)) return shape;
  }
  return std::nullopt;
}

std::vector<std::vector<std::int64_t>> onnxOutputShapes(std::string_view bytes) {
  constexpr std::uint64_t kOutput = 12;
  std::vector<std::vector<std::int64_t>> shapes;
  MessageReader graph(child(bytes, kGraph));
  while (const auto field = graph.next()) {
    if (field->number == kOutput) shapes.push_back(shapeOf(field->bytes));
  }
  return shapes;
}

std::map<std::string, std::string> onnxMetadata(std::string_view bytes) {
  constexpr std::uint64_t kMetadata = 14, kKey = 1, kValue = 2;
  std::map<std::string, std::string> metadata;
  MessageReader model(bytes);
  while (const auto field = model.next()) {
    if (field->number == kMetadata) metadata.emplace(child(field->bytes, kKey), child(field->bytes, kValue));
  }
  return metadata;
}

bool takesHalfFloats(std::string_view bytes) {
  constexpr std::uint64_t kInput = 11, kType = 2, kTensorType = 1, kElementType = 1, kFloat16 = 10;
  MessageReader graph(child(bytes, kGraph));
  while (const auto field = graph.next()) {
    if (field->number != kInput) continue;
    MessageReader tensor(child(child(field->bytes, kType), kTensorType));
    while (const auto part = tensor.next()) {
      if (part->number == kElementType && part->value == kFloat16) return true;
    }
  }
  return false;
}

std::vector<std::string> onnxOutputs(std::string_view bytes) {
  constexpr std::uint64_t kOutput = 12, kName = 1;
  std::vector<std::string> names;
  MessageReader graph(child(bytes, kGraph));
  while (const auto field = graph.next()) {
    if (field->number == kOutput) names.emplace_back(child(field->bytes, kName));
  }
  return names;
}

}  // namespace wardslam::segmentation
