#include "compiler/materials/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/materials/texture_cache.h"

namespace citykiln::materials {
namespace {

constexpr double kTolerances_m[] = {0.02, 0.05, 0.1, 0.2};

std::vector<Material> all_materials() {
  std::vector<Material> all;
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m) all.push_back(static_cast<Material>(m));
  return all;
}

// Drawn once for each seed.
std::vector<Texture> all_textures(double tolerance_m, std::uint64_t seed = 1) {
  static std::map<std::uint64_t, TextureCache> caches;
  const std::vector<SharedTexture> shared =
      caches.try_emplace(seed, seed).first->second.textures_of(all_materials(), tolerance_m);
  std::vector<Texture> textures(shared.begin(), shared.end());
  EXPECT_EQ(std::ranges::all_of(textures, [](const Texture& t) { return has_holes(t.material); }),
            !has_detail(Detail::kMaterialTextures, tolerance_m));
  return textures;
}

std::string name_of(const Texture& texture) { return std::string(values_of(texture.material).name); }

std::array<double, 3> mean_of(const TextureImage& image) {
  std::array<double, 3> mean{};
  for (const TextureImage::Texel& texel : image.texels)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += linear_of_srgb(texel[c]) / static_cast<double>(image.texels.size());
  return mean;
}

// The mean differences between neighbouring rows or columns; the last is that between the last and the first.
std::vector<double> differences(const TextureImage& image, bool across) {
  std::vector<double> all;
  const std::uint32_t side = image.columns;
  for (std::uint32_t i = 0; i < side; ++i) {
    double sum = 0;
    for (std::uint32_t k = 0; k < side; ++k) {
      const std::uint32_t next = (i + 1) % side;
      const TextureImage::Texel& a = across ? image.texels[k * side + i] : image.texels[i * side + k];
      const TextureImage::Texel& b = across ? image.texels[k * side + next] : image.texels[next * side + k];
      for (std::size_t c = 0; c < 3; ++c) sum += std::abs(a[c] - b[c]);
    }
    all.push_back(sum);
  }
  return all;
}

TEST(Texture, RepeatsWithoutASeam) {
  for (const Texture& texture : all_textures(0.02))
    for (const TextureImage* image : {&texture.colour, &texture.normal})
      for (const bool across : {false, true}) {
        if (image->texels.empty()) continue;
        const std::vector<double> steps = differences(*image, across);
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

TEST(Texture, IsAFunctionOfItsSeed) {
  EXPECT_EQ(texture_of(Material::kGrass, 0.02, 1), texture_of(Material::kGrass, 0.02, 1));
  EXPECT_NE(texture_of(Material::kGrass, 0.02, 1), texture_of(Material::kGrass, 0.02, 2));
}

TEST(Texture, IsTheSameAtAllTolerancesButForNormals) {
  const std::vector<Texture> finest = all_textures(kTolerances_m[0]);
  for (const double tolerance_m : kTolerances_m) {
    const std::vector<Texture> textures = all_textures(tolerance_m);
    ASSERT_EQ(textures.size(), finest.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
      EXPECT_EQ(textures[i].colour, finest[i].colour) << name_of(textures[i]);
      EXPECT_EQ(textures[i].normal.texels.empty(), !has_normals(textures[i].material, tolerance_m));
    }
  }
}

TEST(Texture, IsASquareThatDividesThePeriod) {
  for (const Texture& texture : all_textures(0.02)) {
    EXPECT_EQ(std::fmod(kTexturePeriod_m, side_m(texture)), 0) << name_of(texture);
    for (const TextureImage* image : {&texture.colour, &texture.normal}) {
      if (image->texels.empty()) continue;
      EXPECT_TRUE(std::has_single_bit(image->columns));
      EXPECT_EQ(image->columns, image->rows);
      EXPECT_EQ(image->texels.size(), std::size_t{image->columns} * image->rows);
      EXPECT_EQ(image->columns * image->texel_m, side_m(texture));
    }
  }
}

// Where people walk, and on walls beside them: a pixel of 1280 at 90 degrees covers 4 mm at 2.5 m.
TEST(Texture, IsSharpAtEyeHeight) {
  for (const Material material : {Material::kPaving, Material::kBrick})
    EXPECT_LE(texture_of(material, 0.1, 1).colour.texel_m, 0.004);
  for (const Material material : {Material::kAsphalt, Material::kOldAsphalt, Material::kConcrete, Material::kStone,
                                  Material::kGravel, Material::kGrass})
    EXPECT_LE(texture_of(material, 0.1, 1).colour.texel_m, 0.008);
}

TEST(Texture, IsNoneOnCoarseLevels) {
  for (const double tolerance_m : {0.5, 2.5, 12.5}) EXPECT_TRUE(all_textures(tolerance_m).empty());
  for (const Texture& texture : all_textures(tolerances_with(Detail::kMaterialTextures).below_m))
    EXPECT_FALSE(texture.opacity.empty());
}

TEST(Texture, HasOpacityIfItHasHoles) {
  for (const Texture& texture : all_textures(0.1))
    EXPECT_EQ(texture.opacity.size(), has_holes(texture.material) ? texture.colour.texels.size() : 0);
}

bool has_waves(const Texture& texture) { return is_water(texture.material); }

TEST(Texture, HasFewColoursAndNormalsSoThatAPaletteHoldsThem) {
  for (const Texture& texture : all_textures(0.02)) {
    const std::set<TextureImage::Texel> colours(texture.colour.texels.begin(), texture.colour.texels.end());
    EXPECT_LE(colours.size(), 210u) << name_of(texture);
    const std::set<TextureImage::Texel> normals(texture.normal.texels.begin(), texture.normal.texels.end());
    const bool is_water = has_waves(texture);
    EXPECT_LE(normals.size(), is_water ? 10000u : 225u) << name_of(texture);
  }
}

// The number of joints along v: of rows whose mean brightness stands out from the rows around them.
int courses_of(Material material) {
  const TextureImage image = texture_of(material, 0.02, 1).colour;
  std::vector<double> rows(image.rows, 0);
  for (std::size_t i = 0; i < image.texels.size(); ++i)
    rows[i / image.columns] += linear_of_srgb(image.texels[i][2]) / image.columns;
  double mean = 0, deviation = 0;
  for (const double row : rows) mean += row / static_cast<double>(rows.size());
  for (const double row : rows) deviation += (row - mean) * (row - mean) / static_cast<double>(rows.size());
  const double least = mean + 0.8 * std::sqrt(deviation);
  int joints = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) joints += rows[i] > least && rows[(i + 1) % rows.size()] <= least;
  return joints;
}

TEST(Texture, BricksHaveTheHeightsOfTheirStandards) {
  const auto height_m = [](Material material) { return texture_side_m(material) / courses_of(material); };
  EXPECT_NEAR(height_m(Material::kBrick), 0.0833, 0.0005);         // DIN 4172: twelve courses a metre
  EXPECT_NEAR(height_m(Material::kModularBrick), 0.0677, 0.0015);  // three courses to 8 inches
  EXPECT_NEAR(height_m(Material::kEnglishBrick), 0.075, 0.0025);   // BS 4729
  EXPECT_NEAR(height_m(Material::kFlemishBrick), 0.075, 0.0025);
}

// Mean brightness of columns from u = from to up_to, as shares of the side.
double brightness_of(const TextureImage& image, double from, double up_to) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < image.texels.size(); ++i) {
    const double u = (static_cast<double>(i % image.columns) + 0.5) / image.columns;
    if (u >= from && u < up_to) sum += linear_of_srgb(image.texels[i][1]), ++count;
  }
  return sum / count;
}

TEST(Texture, StreetsHaveLightWheelTracksAndDarkGutters) {
  const TextureImage image = texture_of(Material::kStreetAsphalt, 0.1, 1).colour;
  const double gutters = (brightness_of(image, 0, 0.04) + brightness_of(image, 0.96, 1)) / 2;
  const double between = (brightness_of(image, 0.25, 0.29) + brightness_of(image, 0.71, 0.75)) / 2;
  for (const double track : {0.155, 0.390, 0.610, 0.845}) {
    EXPECT_GT(brightness_of(image, track - 0.03, track + 0.03), 1.04 * between) << track;
    EXPECT_GT(between, 1.02 * gutters);
  }
}

TEST(Texture, ScalesItsTexelsAlone) {
  for (const Material material : {Material::kBrick, Material::kGrass, Material::kAsphalt}) {
    const Texture usual = texture_of(material, 0.02, 1), fine = texture_of(material, 0.02, 1, 2);
    EXPECT_EQ(fine.colour.columns, 2 * usual.colour.columns);
    EXPECT_EQ(side_m(fine), side_m(usual));
  }
}

TEST(Texture, HasRoughnessWhereItHasNormals) {
  for (const double tolerance_m : kTolerances_m)
    for (const Texture& texture : all_textures(tolerance_m)) {
      if (texture.surface.texels.empty()) continue;
      EXPECT_TRUE(has_normals(texture.material, tolerance_m)) << name_of(texture);
      double mean = 0;
      for (const TextureImage::Texel& texel : texture.surface.texels)
        mean += texel[1] / 255.0 / static_cast<double>(texture.surface.texels.size());
      EXPECT_NEAR(mean, values_of(texture.material).roughness, 0.06) << name_of(texture);
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
    EXPECT_NEAR(v / count, 0, 0.05) << name_of(texture);  // tiles rise slowly, and end steeply where slopes are clamped
  }
  EXPECT_GT(shaped, 50);
}

TEST(Texture, HasNormalsForWaterAloneOnCoarserLevels) {
  for (const Texture& texture : all_textures(0.1)) {
    const bool is_water = has_waves(texture);
    EXPECT_EQ(texture.normal.texels.empty(), !is_water) << name_of(texture);
  }
}

// Where a pixel covers an eighth of a side, hardly any repetition is visible. Bark may vary more, since few repetitions
// are visible at once, and single slates or stones stand out.
TEST(Texture, IsUniformFromAfar) {
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
        EXPECT_NEAR(sum / mean, 1, has_no_units(texture.material) ? 0.15 : 0.23) << name_of(texture);
      }
  }
}

}  // namespace
}  // namespace citykiln::materials
