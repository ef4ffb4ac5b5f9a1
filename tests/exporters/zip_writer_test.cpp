#include "exporters/zip_writer.h"

#include <gtest/gtest.h>

#include "exporters/stored_zip.h"
#include "tests/exporters/little_endian.h"

namespace citykiln::exporters {
namespace {

constexpr std::uint64_t kFar = 5'000'000'000, kWide = 0xffffffff;
const std::vector<std::byte> kBytes(10, std::byte{3});

TEST(ZipWriter, WritesSmallArchivesWithoutZip64) {
  ZipWriter zip;
  EXPECT_EQ(add_zip_file(zip, "ab", kBytes)->size(), 32u);
  EXPECT_EQ(zip.size, 42u);
  const std::vector<std::byte> end = zip_directory(zip);
  ASSERT_EQ(end.size(), 48u + 22);
  EXPECT_EQ(number_at(end, 42, 4), 0u);
  EXPECT_EQ(number_at(end, 48, 4), 0x06054b50u);
  EXPECT_EQ(number_at(end, 58, 2), 1u);
  EXPECT_EQ(number_at(end, 60, 4), 48u);
  EXPECT_EQ(number_at(end, 64, 4), 42u);
}

TEST(ZipWriter, AlignsTheDataWhenAsked) {
  ZipWriter zip{.alignment = 64};
  for (const char* name : {"a", "another", "third"}) {
    const std::uint64_t before = zip.size;
    EXPECT_EQ((before + add_zip_file(zip, name, kBytes)->size()) % 64, 0u);
  }
}

TEST(ZipWriter, GivesFarOffsetsIn64Bits) {
  ZipWriter zip{.size = kFar};
  const std::vector<std::byte> header = *add_zip_file(zip, "ab", kBytes);
  EXPECT_EQ(header.size(), 32u);
  const std::vector<std::byte> end = zip_directory(zip);
  // the entry, with the offset in an extra field
  EXPECT_EQ(number_at(end, 6, 2), 45u);
  EXPECT_EQ(number_at(end, 30, 2), 12u);
  EXPECT_EQ(number_at(end, 42, 4), kWide);
  EXPECT_EQ(number_at(end, 48, 4), 0x00080001u);
  EXPECT_EQ(number_at(end, 52, 8), kFar);
  // the end in 64 bits, the place of this end, and the end
  ASSERT_EQ(end.size(), 60u + 56 + 20 + 22);
  EXPECT_EQ(number_at(end, 60, 4), 0x06064b50u);
  EXPECT_EQ(number_at(end, 64, 8), 44u);
  EXPECT_EQ(number_at(end, 84, 8), 1u);
  EXPECT_EQ(number_at(end, 92, 8), 1u);
  EXPECT_EQ(number_at(end, 100, 8), 60u);
  EXPECT_EQ(number_at(end, 108, 8), kFar + 42);
  EXPECT_EQ(number_at(end, 116, 4), 0x07064b50u);
  EXPECT_EQ(number_at(end, 124, 8), kFar + 42 + 60);
  EXPECT_EQ(number_at(end, 136, 4), 0x06054b50u);
  EXPECT_EQ(number_at(end, 152, 4), kWide);
}

TEST(ZipWriter, CountsManyFilesIn64Bits) {
  ZipWriter zip;
  for (int i = 0; i < 65535; ++i) ASSERT_TRUE(add_zip_file(zip, "a", {}));
  const std::vector<std::byte> end = zip_directory(zip);
  EXPECT_EQ(number_at(end, end.size() - 12, 2), 0xffffu);
  EXPECT_EQ(number_at(end, end.size() - 98 + 24, 8), 65535u);
  EXPECT_EQ(number_at(end, end.size() - 6, 4), zip.size);
}

TEST(ZipWriter, RefusesFilesOf4GB) {
  ZipWriter zip;
  // an error before any byte is read
  EXPECT_FALSE(add_zip_file(zip, "a", std::span<const std::byte>(kBytes.data(), kWide)));
  EXPECT_EQ(zip.files, 0u);
}

TEST(StoredZip, IsTheHeadersTheFilesAndTheDirectory) {
  const std::vector<ZippedFile> files = {{"one", kBytes}, {"two/three", std::vector<std::byte>(100)}};
  ZipWriter zip{.alignment = 16};
  std::vector<std::byte> expected;
  const auto put = [&](const std::vector<std::byte>& bytes) {
    expected.insert(expected.end(), bytes.begin(), bytes.end());
  };
  for (const ZippedFile& file : files) put(*add_zip_file(zip, file.name, file.bytes)), put(file.bytes);
  put(zip_directory(zip));
  EXPECT_EQ(*stored_zip(files, 16), expected);
}

}  // namespace
}  // namespace citykiln::exporters
