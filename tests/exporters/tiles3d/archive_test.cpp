#include "exporters/tiles3d/archive.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "exporters/tiles3d/md5.h"
#include "tests/exporters/little_endian.h"

namespace citykiln::exporters {
namespace {

std::string hex_of(const std::string& text) {
  std::string hex;
  for (const std::byte byte : md5(text)) hex += fmt::format("{:02x}", static_cast<unsigned>(byte));
  return hex;
}

// printed by md5sum; the first six are those of RFC 1321
TEST(Md5, IsThatOfTheStandard) {
  EXPECT_EQ(hex_of(""), "d41d8cd98f00b204e9800998ecf8427e");
  EXPECT_EQ(hex_of("a"), "0cc175b9c0f1b6a831c399e269772661");
  EXPECT_EQ(hex_of("abc"), "900150983cd24fb0d6963f7d28e17f72");
  EXPECT_EQ(hex_of("message digest"), "f96b697d7cb7938d525a2f31aaf161d0");
  EXPECT_EQ(hex_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"),
            "d174ab98d277d9f5a5611c2c9f419d9f");
  EXPECT_EQ(hex_of("12345678901234567890123456789012345678901234567890123456789012345678901234567890"),
            "57edf4a22be3c955ac49da2e2107b67a");
}

// the lengths around the ends of blocks and of their padding, printed by md5sum
TEST(Md5, PadsEveryLength) {
  EXPECT_EQ(hex_of(std::string(55, 'a')), "ef1772b6dff9a122358552954ad0df65");
  EXPECT_EQ(hex_of(std::string(56, 'a')), "3b0c8ac703f828b04c6c197006d17218");
  EXPECT_EQ(hex_of(std::string(64, 'a')), "014842d480b571495a4a0363793f7367");
  EXPECT_EQ(hex_of(std::string(119, 'a')), "8a7bd0732ed6a28ce75f6dabc90e1613");
}

TEST(TilesetArchive, HasASortedIndexThatLeadsToTheHeaders) {
  TilesetArchive archive;
  std::vector<std::byte> whole;
  const auto put = [&](const std::vector<std::byte>& bytes) { whole.insert(whole.end(), bytes.begin(), bytes.end()); };
  for (int i = 0; i < 100; ++i) {
    const std::vector<std::byte> bytes(static_cast<std::size_t>(i) + 1, std::byte{7});
    put(*add_to_archive(archive, fmt::format("{}_0_L0.glb", i), bytes));
    put(bytes);
  }
  const std::vector<std::byte> index = archive_index(archive.index);
  ASSERT_EQ(index.size(), 2400u);
  std::pair<std::uint64_t, std::uint64_t> before;
  for (std::size_t at = 0; at < index.size(); at += 24) {
    const std::pair here{number_at(index, at, 8), number_at(index, at + 8, 8)};
    EXPECT_LT(before, here);
    before = here;
    const std::uint64_t offset = number_at(index, at + 16, 8);
    ASSERT_EQ(number_at(whole, offset, 4), 0x04034b50u);
    const std::string name = text_at(whole, offset + 30, number_at(whole, offset + 26, 2));
    const std::array<std::byte, 16> hash = md5(name);
    EXPECT_TRUE(std::equal(hash.begin(), hash.end(), index.begin() + static_cast<std::ptrdiff_t>(at))) << name;
  }
}

TEST(TilesetArchive, SortsByTheFirstHalfAsALittleEndianNumber) {
  std::vector<ArchivePlace> places(3);
  places[0].md5[7] = std::byte{1}, places[0].offset = 1;  // the most important byte
  places[1].md5[0] = std::byte{255}, places[1].offset = 2;
  places[2].md5[15] = std::byte{255}, places[2].offset = 3;  // the second half
  const std::vector<std::byte> index = archive_index(places);
  EXPECT_EQ(number_at(index, 16, 8), 3u);
  EXPECT_EQ(number_at(index, 40, 8), 2u);
  EXPECT_EQ(number_at(index, 64, 8), 1u);
}

TEST(TilesetArchive, EndsWithTheEntryOfItsIndex) {
  TilesetArchive archive;
  ASSERT_TRUE(add_to_archive(archive, "tileset.json", std::vector<std::byte>(5)));
  const std::uint64_t start = archive.zip.size;
  const std::vector<std::byte> end = *end_of_archive(archive);
  EXPECT_EQ(text_at(end, 30, 15), "@3dtilesIndex1@");
  EXPECT_EQ(number_at(end, 18, 4), 24u);
  const std::size_t entry = end.size() - 22 - 46 - 15;
  EXPECT_EQ(number_at(end, entry, 4), 0x02014b50u);
  EXPECT_EQ(number_at(end, entry + 42, 4), start);
  EXPECT_EQ(text_at(end, entry + 46, 15), "@3dtilesIndex1@");
}

}  // namespace
}  // namespace citykiln::exporters
