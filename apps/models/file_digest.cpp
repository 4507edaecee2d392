#include "models/file_digest.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

std::string toHex(const unsigned char* bytes, std::size_t count) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 15U];
  }
  return text;
}

}  // namespace

std::string fileDigest(const std::filesystem::path& file, const std::string& algorithm) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw core::InputError(file.string() + ": cannot be opened for reading");
  }
  const EVP_MD* method = EVP_get_digestbyname(algorithm.c_str());
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  if (method == nullptr || EVP_DigestInit_ex(context.get(), method, nullptr) != 1) {
    throw std::invalid_argument("no such checksum: " + algorithm);
  }
  std::vector<char> buffer(1U << 16U);
  do {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    EVP_DigestUpdate(context.get(), buffer.data(), static_cast<std::size_t>(in.gcount()));
  } while (in);
  if (in.bad()) throw core::InputError(file.string() + ": cannot be read to its end");
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_DigestFinal_ex(context.get(), digest.data(), &length);
  return toHex(digest.data(), length);
}

std::size_t digestLength(const std::string& algorithm) {
  const EVP_MD* method = EVP_get_digestbyname(algorithm.c_str());
  return method == nullptr ? 0 : 2 * static_cast<std::size_t>(EVP_MD_get_size(method));
}

}  // namespace wardslam::apps
