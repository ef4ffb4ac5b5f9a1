#include "exporters/gltf/pictures/png.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace citykiln::exporters {
namespace {

using materials::TextureImage;
using Bytes = std::vector<std::byte>;

/// Texels of so many colours at most, 0.
TextureImage picture_of_colours(std::uint32_t columns, std::uint32_t rows, std::uint32_t colours) {
  std::mt19937 dice(columns * 7 + rows + colours);
  TextureImage sheet{0, columns, rows, {}};
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    const std::uint32_t colour = static_cast<std::uint32_t>(dice()) % colours;
    sheet.texels.push_back({static_cast<std::uint8_t>(colour), static_cast<std::uint8_t>(colour >> 8), 200});
  }
  return sheet;
}

std::string png_refusal(const Result<TextureImage>& result) { return result ? "accepted" : to_string(result.error()); }

void put_big_endian(Bytes& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::byte>(value >> 8 * (3 - i));
}

// The checksum of PNG chunks, as in the specification.
std::uint32_t crc(std::span<const std::byte> bytes) {
  std::uint32_t c = 0xffffffffu;
  for (const std::byte b : bytes) {
    c ^= static_cast<std::uint32_t>(b);
    for (int i = 0; i < 8; ++i) c = (c & 1) != 0 ? 0xedb88320u ^ c >> 1 : c >> 1;
  }
  return ~c;
}

TEST(Png, ReadsBackWhatItWrote) {
  const std::pair<int, int> sizes[] = {{1, 1}, {1, 9}, {300, 1}, {7, 13}, {64, 64}, {129, 255}};
  for (const auto& [columns, rows] : sizes)
    for (const std::uint32_t colours : {1u, 2u, 3u, 5u, 17u, 256u, 257u, 65536u}) {
      const TextureImage sheet =
          picture_of_colours(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), colours);
      const auto back = decode_png(encode_png(sheet), "p");
      ASSERT_TRUE(back) << png_refusal(back);
      ASSERT_EQ(*back, sheet) << columns << " by " << rows << " of " << colours;
    }
}

TEST(Png, KeepsEveryGrey) {
  TextureImage sheet{0, 256, 1, {}};
  for (int i = 0; i < 256; ++i) sheet.texels.push_back({std::uint8_t(i), std::uint8_t(i), std::uint8_t(i)});
  EXPECT_EQ(*decode_png(encode_png(sheet), "p"), sheet);
}

TEST(Png, SameTexelsSameBytes) {
  EXPECT_EQ(encode_png(picture_of_colours(90, 40, 300)), encode_png(picture_of_colours(90, 40, 300)));
}

TEST(Png, FewColoursTakeAPalette) {
  constexpr std::size_t kColourType = 25, kPalette = 3, kRgb = 2;
  for (const std::uint32_t colours : {2u, 256u, 60000u}) {
    const Bytes bytes = encode_png(picture_of_colours(200, 200, colours));
    EXPECT_EQ(static_cast<std::size_t>(bytes[kColourType]), colours <= 256 ? kPalette : kRgb) << colours;
  }
  // two colours, a bit each, before deflate
  EXPECT_LT(encode_png(picture_of_colours(200, 200, 2)).size(), 200u * 200 / 8 * 5 / 4);
}

TEST(PngDamage, EveryTruncationIsRefusedUntilThePictureIsWhole) {
  const TextureImage sheet = picture_of_colours(20, 20, 1000);
  const Bytes bytes = encode_png(sheet);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto read = decode_png(std::span(bytes).first(size), "p");
    if (read) {
      ASSERT_EQ(*read, sheet) << size;
    }
  }
  EXPECT_EQ(png_refusal(decode_png(std::span(bytes).first(bytes.size() / 2), "p")).substr(0, 31),
            "p: expected a whole PNG picture");
}

TEST(PngDamage, WhatIsNoPngIsRefused) {
  const Bytes nothing, text(100, std::byte{'x'});
  EXPECT_EQ(png_refusal(decode_png(nothing, "p")).substr(0, 25), "p: expected a PNG picture");
  EXPECT_EQ(png_refusal(decode_png(text, "p")).substr(0, 25), "p: expected a PNG picture");
}

TEST(PngDamage, AChangedByteIsRefusedOrMakesAnotherPicture) {
  std::mt19937 dice(4);
  const Bytes bytes = encode_png(picture_of_colours(30, 20, 50));
  ASSERT_FALSE(bytes.empty());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    Bytes changed = bytes;
    changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
    const auto read = decode_png(changed, "p");
    if (!read) continue;
    ASSERT_EQ(*decode_png(encode_png(*read), "again"), *read) << at;
  }
}

// A header that states an impossible size takes no memory.
TEST(PngDamage, SizesBeyondTheFileAreRefused) {
  constexpr std::size_t kWidth = 16, kHeight = 20, kType = 12, kEnd = 29;
  const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{16385, 1}, {1, 16385}, {16384, 16384}, {8000, 8000}};
  for (const auto& [width, height] : sizes) {
    Bytes bytes = encode_png(picture_of_colours(4, 4, 2));
    put_big_endian(bytes, kWidth, width), put_big_endian(bytes, kHeight, height);
    put_big_endian(bytes, kEnd, crc(std::span(bytes).subspan(kType, kEnd - kType)));
    EXPECT_EQ(png_refusal(decode_png(bytes, "p")), "p: expected a picture of no more texels than an image may have");
  }
}

}  // namespace
}  // namespace citykiln::exporters
