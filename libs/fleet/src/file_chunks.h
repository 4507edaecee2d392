#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pqxx_compat.h"

namespace wardslam::fleet {

/// What a file holds, in pieces of 1 MiB.
struct FileDigests {
  std::vector<std::string> chunks;
  std::string whole;  ///< DigestOfParts of the chunks.
  std::uint64_t size_bytes = 0;
};

/// Throws core::InputError where the file cannot be read.
[[nodiscard]] FileDigests digestsOf(const std::filesystem::path& file);

/// Sends what the database has not of any file, each piece for good: what breaks off goes on from there. After each
/// piece `onSent` is told how many bytes that were.
void sendChunks(pqxx::connection& connection, const std::filesystem::path& file, const FileDigests& digests,
                const std::function<void(std::uint64_t)>& onSent);

/// Has the map's file be made of these pieces, which are there.
void makeFile(pqxx::transaction_base& transaction, std::int64_t map, const FileDigests& digests);

/// Writes the file that the database holds. Throws core::InputError where it is not what was sent.
void fetchFile(pqxx::transaction_base& transaction, std::int64_t map, const std::string& wholeDigest,
               const std::filesystem::path& file);

}  // namespace wardslam::fleet
