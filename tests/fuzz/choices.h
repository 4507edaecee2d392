#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace wardslam::fuzz {

/// Takes numbers from the input; zeros behind its end.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  [[nodiscard]] bool areLeft() const { return left_ > 0; }

  template <class Number>
  Number take() {
    Number number{};
    const std::size_t count = std::min(left_, sizeof number);
    if (count > 0) std::memcpy(&number, data_, count);
    data_ += count;
    left_ -= count;
    return number;
  }

  std::size_t below(std::size_t end) { return end == 0 ? 0 : take<std::uint8_t>() % end; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace wardslam::fuzz
