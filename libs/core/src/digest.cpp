#include "wardslam/core/digest.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

constexpr std::size_t kChunk_bytes = std::size_t{1} << 20U;

void require(int success) {
  if (success != 1) throw std::runtime_error("OpenSSL computes no checksum");
}

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 15U];
  }
  return text;
}

}  // namespace

struct Digest::Context {
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> evp{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

Digest::Digest(const std::string& algorithm) : context_(std::make_unique<Context>()) {
  const EVP_MD* method = EVP_get_digestbyname(algorithm.c_str());
  if (method == nullptr) throw std::invalid_argument("no such checksum: " + algorithm);
  require(EVP_DigestInit_ex(context_->evp.get(), method, nullptr));
}
Digest::~Digest() = default;
Digest::Digest(Digest&&) noexcept = default;
Digest& Digest::operator=(Digest&&) noexcept = default;

void Digest::add(const void* bytes, std::size_t size) { require(EVP_DigestUpdate(context_->evp.get(), bytes, size)); }

void Digest::addFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw InputError(file.string() + ": cannot be opened for reading");
  }
  std::vector<char> chunk(kChunk_bytes);
  do {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    add(chunk.data(), static_cast<std::size_t>(in.gcount()));
  } while (in);
  if (in.bad()) throw InputError(file.string() + ": cannot be read to its end");
}

std::string Digest::result() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  require(EVP_DigestFinal_ex(context_->evp.get(), digest.data(), &length));
  return hexadecimal(digest.data(), length);
}

std::string digestOf(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.result();
}

std::string digestOfFile(const std::filesystem::path& file, const std::string& algorithm) {
  Digest digest(algorithm);
  digest.addFile(file);
  return digest.result();
}

std::size_t digestLength(const std::string& algorithm) {
  const EVP_MD* method = EVP_get_digestbyname(algorithm.c_str());
  return method == nullptr ? 0 : 2 * static_cast<std::size_t>(EVP_MD_get_size(method));
}

}  // namespace wardslam::core
