#include "byte_source.h"

#include <gtest/gtest.h>
#include <zlib.h>
#include <zstd.h>

#include <vector>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

/// More than any buffer holds, and not all alike.
std::string content() {
  std::string text;
  std::uint32_t number = 1;
  for (int i = 0; i < 200000; ++i) text += std::to_string(number = number * 1664525U + 1013904223U);
  return text;
}

std::string zstd(const std::string& text) {
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 1));
  return packed;
}

std::string readAll(ByteSource& source, std::size_t step) {
  std::string text;
  std::string part(step, '\0');
  while (const std::size_t count = source.read(reinterpret_cast<std::uint8_t*>(part.data()), step)) {
    text.append(part, 0, count);
  }
  return text;
}

class Bytes : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
  const std::string text = content();
};

TEST_F(Bytes, OfZstandardAreDecompressed) {
  const std::string packed = zstd(text);
  for (const std::size_t step : {std::size_t{1000}, std::size_t{7}, text.size()}) {
    const auto source = openBytes(folder.write("a", packed));
    EXPECT_EQ(readAll(*source, step), text);
    EXPECT_EQ(source->consumed_bytes(), packed.size());
  }
}

TEST_F(Bytes, OfSeveralFramesFollowEachOther) {
  EXPECT_EQ(readAll(*openBytes(folder.write("a", zstd("one") + zstd("two"))), 100), "onetwo");
}

TEST_F(Bytes, EndWhereTheFileIsCutOff) {
  const std::string packed = zstd(text);
  const std::string half = readAll(*openBytes(folder.write("a", packed.substr(0, packed.size() / 2))), 1000);
  EXPECT_LT(half.size(), text.size());
  EXPECT_GT(half.size(), 0U);
  EXPECT_EQ(text.compare(0, half.size(), half), 0);
  EXPECT_EQ(readAll(*openBytes(folder.write("a", zstd("abc").substr(0, 4) + std::string(50, '\xff'))), 10), "");
}

TEST_F(Bytes, OfGzAndPlainFilesToo) {
  EXPECT_EQ(readAll(*openBytes(folder.write("a", text)), 1000), text);
  const auto file = folder.path() / "a.gz";
  gzFile gz = gzopen(file.c_str(), "wb");
  gzwrite(gz, text.data(), static_cast<unsigned>(text.size()));
  gzclose(gz);
  EXPECT_EQ(readAll(*openBytes(file), 1000), text);
  EXPECT_THROW((void)openBytes(folder.path()), core::InputError);
}

}  // namespace
}  // namespace wardslam::sources
