#include "compiler/materials/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "compiler/contract/detail_tolerances.h"

namespace citykiln::materials {
namespace {

constexpr double kTolerances_m[] = {0.02, 0.05, 0.1, 0.2};

std::vector<Material> all_materials() {
  std::vector<Material> all;
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m) all.push_back(static_cast<Material>(m));
  return all;
}

std::vector<Texture> all_textures(double tolerance_m, std::uint64_t seed = 1) {
  return textures_of(all_materials(), tolerance_m, seed);
}

std::string name_of(const Texture& texture) { return std::string(values_of(texture.material).name); }

std::array<double, 3> mean_of(const TextureImage& sheet) {
  std::array<double, 3> mean{};
  for (const TextureImage::Texel& texel : sheet.texels)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += linear_of_srgb(texel[c]) / static_cast<double>(sheet.texels.size());
  return mean;
}

// The mean difference between rows or columns that are neighbours, by the place between them; the last is that of the
// last with the first.
std::vector<double> differences(const TextureImage& sheet, bool across) {
  std::vector<double> all;
  const std::uint32_t side = sheet.columns;
  for (std::uint32_t i = 0; i < side; ++i) {
    double sum = 0;
    for (std::uint32_t k = 0; k < side; ++k) {
      const std::uint32_t next = (i + 1) % side;
      const TextureImage::Texel& a = across ? sheet.texels[k * side + i] : sheet.texels[i * side + k];
      const TextureImage::Texel& b = across ? sheet.texels[k * side + next] : sheet.texels[next * side + k];
      for (std::size_t c = 0; c < 3; ++c) sum += std::abs(a[c] - b[c]);
    }
    all.push_back(sum);
  }
  return all;
}

TEST(Texture, RepeatsWithoutASeam) {
  for (const Texture& texture : all_textures(0.02))
    for (const TextureImage* sheet : {&texture.colour, &texture.normal})
      for (const bool across : {false, true}) {
        if (sheet->texels.empty()) continue;
        const std::vector<double> steps = differences(*sheet, across);
        const double largest_inside = *std::max_element(steps.begin(), steps.end() - 1);
        EXPECT_LE(steps.back(), 1.25 * largest_inside) << name_of(texture);
      }
}

TEST(Texture, HasTheMaterialsColourAsItsMeanOnEveryLevel) {
  for (const double tolerance_m : kTolerances_m)
    for (const Texture& texture : all_textures(tolerance_m)) {
      const auto factor = colour_factor(texture);
      const auto mean = texture.colour.texels.empty() ? std::array<double, 3>{1, 1, 1} : mean_of(texture.colour);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(mean[c] * factor[c], values_of(texture.material).base_colour[c], 1e-6) << name_of(texture);
        EXPECT_LE(factor[c], 1) << name_of(texture);
        if (!texture.colour.texels.empty()) {
          EXPECT_GT(factor[c], 0.9) << name_of(texture);
        }
      }
    }
}

TEST(Texture, SameBytesAlwaysAndOthersForAnotherSeed) {
  EXPECT_EQ(all_textures(0.02, 1), all_textures(0.02, 1));
  EXPECT_NE(texture_of(Material::kGrass, 0.02, 1), texture_of(Material::kGrass, 0.02, 2));
}

TEST(Texture, TexelsAreAsLargeAsTheToleranceAndDivideThePeriod) {
  for (const double tolerance_m : kTolerances_m)
    for (const Texture& texture : all_textures(tolerance_m)) {
      EXPECT_EQ(std::fmod(kTexturePeriod_m, side_m(texture)), 0) << name_of(texture);
      for (const TextureImage* sheet : {&texture.colour, &texture.normal}) {
        if (sheet->texels.empty()) continue;
        EXPECT_GE(sheet->texel_m, is_bark(texture.material) ? tolerance_m / kBarkTexelsPerTolerance : tolerance_m)
            << name_of(texture);
        EXPECT_EQ(sheet->columns, sheet->rows);
        EXPECT_EQ(sheet->texels.size(), std::size_t{sheet->columns} * sheet->rows);
        EXPECT_EQ(sheet->columns * sheet->texel_m, side_m(texture));
      }
    }
}

TEST(Texture, IsNotThereWhereRoadsAreOneSurface) {
  for (const double tolerance_m : {tolerances_with(Detail::kMaterialTextures).below_m, 0.5, 2.5, 12.5})
    EXPECT_TRUE(all_textures(tolerance_m).empty());
}

TEST(Texture, HasFewColoursAndNormalsSoThatAPaletteHoldsThem) {
  for (const Texture& texture : all_textures(0.02)) {
    const std::set<TextureImage::Texel> colours(texture.colour.texels.begin(), texture.colour.texels.end());
    EXPECT_LE(colours.size(), 16u) << name_of(texture);
    const std::set<TextureImage::Texel> normals(texture.normal.texels.begin(), texture.normal.texels.end());
    const bool is_water = texture.material == Material::kWater || texture.material == Material::kSea;
    EXPECT_LE(normals.size(), is_water ? 10000u : 225u) << name_of(texture);
  }
}

TEST(Texture, NormalsPointOutwardsAndUprightInTheMean) {
  int shaped = 0;
  for (const Texture& texture : all_textures(0.02)) {
    if (texture.normal.texels.empty()) continue;
    ++shaped;
    double u = 0, v = 0;
    for (const TextureImage::Texel& texel : texture.normal.texels) {
      const double n[] = {texel[0] / 127.5 - 1, texel[1] / 127.5 - 1, texel[2] / 127.5 - 1};
      EXPECT_GT(n[2], 0.3);
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 0.02);
      u += n[0], v += n[1];
    }
    const auto count = static_cast<double>(texture.normal.texels.size());
    EXPECT_NEAR(u / count, 0, 0.02) << name_of(texture);
    EXPECT_NEAR(v / count, 0, 0.02) << name_of(texture);
  }
  EXPECT_EQ(shaped, 13);  // water, sea, fields, rock, masonry, tiles, slates, and six barks
}

TEST(Texture, OnlyWatersShapeIsToldFromADecimetreOn) {
  for (const Texture& texture : all_textures(0.1)) {
    const bool is_water = texture.material == Material::kWater || texture.material == Material::kSea;
    EXPECT_EQ(texture.normal.texels.empty(), !is_water) << name_of(texture);
  }
}

// Seen so far off that a pixel covers an eighth of a side, hardly anything is left to see repeating; of bark, of which
// nobody sees many sides at once, not much.
TEST(Texture, IsEvenFromAfar) {
  for (const Texture& texture : all_textures(0.02)) {
    if (texture.colour.texels.empty()) continue;
    const std::uint32_t side = texture.colour.columns, block = side / 8;
    const double mean = mean_of(texture.colour)[1];
    for (std::uint32_t y = 0; y < 8; ++y)
      for (std::uint32_t x = 0; x < 8; ++x) {
        double sum = 0;
        for (std::uint32_t j = 0; j < block; ++j)
          for (std::uint32_t i = 0; i < block; ++i)
            sum += linear_of_srgb(texture.colour.texels[(y * block + j) * side + x * block + i][1]) / block / block;
        EXPECT_NEAR(sum / mean, 1, is_bark(texture.material) ? 0.2 : 0.15) << name_of(texture);
      }
  }
}

}  // namespace
}  // namespace citykiln::materials
