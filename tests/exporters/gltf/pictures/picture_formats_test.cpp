#include "exporters/gltf/pictures/picture_formats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/materials/texture.h"
#include "exporters/gltf/pictures/jpeg.h"

namespace citykiln::exporters {
namespace {

using materials::TextureImage;
using Bytes = std::vector<std::byte>;

TextureImage noise(std::uint32_t columns, std::uint32_t rows) {
  std::mt19937 dice(columns * 31 + rows);
  TextureImage image{0, columns, rows, {}};
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    const auto byte = [&] { return static_cast<std::uint8_t>(dice()); };
    image.texels.push_back({byte(), byte(), byte()});
  }
  return image;
}

std::vector<std::uint8_t> opacities(std::size_t count) {
  std::mt19937 dice(static_cast<std::uint32_t>(count));
  std::vector<std::uint8_t> all(count);
  for (std::uint8_t& o : all) o = dice() % 3 == 0 ? 0 : static_cast<std::uint8_t>(dice());
  return all;
}

TextureImage asphalt() { return materials::texture_of(materials::Material::kAsphalt, 0.1, 1).colour; }

double root_mean_square_difference(const TextureImage& a, const TextureImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.texels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) sum += std::pow(double(a.texels[i][c]) - b.texels[i][c], 2);
  return std::sqrt(sum / (3.0 * static_cast<double>(a.texels.size())));
}

constexpr PictureFormats kAllFormats[] = {PictureFormats::kPng, PictureFormats::kPngAndJpeg, PictureFormats::kWebp};

TEST(PictureFormats, ExactContentAndOpacitiesAreReadBackAsTheyWere) {
  for (const PictureFormats formats : kAllFormats)
    for (const auto& [columns, rows] : {std::pair{1u, 1u}, {5u, 300u}, {64u, 64u}, {129u, 31u}}) {
      const TextureImage image = noise(columns, rows);
      const auto opacity = opacities(image.texels.size());
      const auto exact = decode_picture(encode_picture(image, {}, PictureContent::kExact, formats).bytes, "");
      ASSERT_TRUE(exact);
      EXPECT_EQ(exact->colour, image);
      const auto cut = decode_picture(encode_picture(image, opacity, PictureContent::kColour, formats).bytes, "");
      ASSERT_TRUE(cut);
      EXPECT_EQ(cut->colour, image);
      EXPECT_EQ(cut->opacity, opacity);
    }
}

TEST(PictureFormats, LossOfColoursIsBelowTheirGrain) {
  const TextureImage image = asphalt();
  double grain = 0;
  for (std::size_t i = 1; i < image.texels.size(); ++i)
    grain +=
        std::pow(double(image.texels[i][1]) - image.texels[i - 1][1], 2) / static_cast<double>(image.texels.size());
  for (const PictureContent content : {PictureContent::kColour, PictureContent::kAtlas})
    for (const PictureFormats formats : {PictureFormats::kPngAndJpeg, PictureFormats::kWebp}) {
      const EncodedPicture encoded = encode_picture(image, {}, content, formats);
      const auto back = decode_picture(encoded.bytes, "");
      ASSERT_TRUE(back);
      const double difference = root_mean_square_difference(back->colour, image);
      EXPECT_LT(difference, std::sqrt(grain));
      EXPECT_GT(difference, 0);
      EXPECT_LT(encoded.bytes.size(), encode_png(image).size() / 2);
    }
}

TEST(PictureFormats, SameTexelsSameBytes) {
  for (const PictureFormats formats : kAllFormats) {
    const EncodedPicture a = encode_picture(asphalt(), {}, PictureContent::kColour, formats);
    EXPECT_EQ(a.bytes, encode_picture(asphalt(), {}, PictureContent::kColour, formats).bytes);
  }
}

TEST(PictureFormats, RefusesWhatIsCutOff) {
  for (const PictureFormats formats : kAllFormats) {
    const Bytes bytes = encode_picture(noise(40, 30), {}, PictureContent::kColour, formats).bytes;
    for (std::size_t size = 0; size + 20 < bytes.size(); size += 1 + size / 16)
      EXPECT_FALSE(decode_picture(std::span(bytes).first(size), "")) << static_cast<int>(formats) << ' ' << size;
  }
}

TEST(PictureFormats, DamageNeverCrashes) {
  std::mt19937 dice(5);
  for (const PictureFormats formats : kAllFormats) {
    const Bytes bytes = encode_picture(noise(40, 30), {}, PictureContent::kColour, formats).bytes;
    for (int round = 0; round < 400; ++round) {
      Bytes damaged = bytes;
      for (int i = 0; i < 4; ++i) damaged[dice() % damaged.size()] = static_cast<std::byte>(dice());
      const auto read = decode_picture(damaged, "");
      if (read) {
        EXPECT_EQ(read->colour.texels.size(), std::size_t{read->colour.columns} * read->colour.rows);
      }
    }
  }
}

// A header that claims 16,000 texels on each side.
TEST(PictureFormats, AFewBytesCannotTakeMemoryWithoutLimit) {
  Bytes bytes = encode_jpeg(noise(16, 16), 50, JpegChroma::kHalf);
  for (std::size_t i = 0; i + 9 < bytes.size(); ++i)
    if (bytes[i] == std::byte{0xff} && bytes[i + 1] == std::byte{0xc0})
      bytes[i + 5] = bytes[i + 7] = std::byte{0x3e}, bytes[i + 6] = bytes[i + 8] = std::byte{0x80};
  EXPECT_FALSE(decode_jpeg(bytes, ""));
}

}  // namespace
}  // namespace citykiln::exporters
