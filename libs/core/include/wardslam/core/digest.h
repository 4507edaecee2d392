#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace wardslam::core {

/// Checksum of bytes that come one after the other.
class Digest {
 public:
  /// "sha256", or another one that OpenSSL knows by name. Throws std::invalid_argument when there is no such algorithm.
  explicit Digest(const std::string& algorithm = "sha256");
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;

  void add(const void* bytes, std::size_t size);
  void add(std::string_view bytes) { add(bytes.data(), bytes.size()); }
  /// All that is in a file. Throws InputError when it cannot be read.
  void addFile(const std::filesystem::path& file);

  /// In lower-case hexadecimal. Nothing can be added behind it.
  [[nodiscard]] std::string result();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Of these bytes, by SHA-256.
[[nodiscard]] std::string digestOf(std::string_view bytes);

/// Of a file's content. Throws InputError when it cannot be read, std::invalid_argument as Digest does.
[[nodiscard]] std::string digestOfFile(const std::filesystem::path& file, const std::string& algorithm = "sha256");

/// Number of digits of such a checksum; 0 when there is no such algorithm.
[[nodiscard]] std::size_t digestLength(const std::string& algorithm);

}  // namespace wardslam::core
