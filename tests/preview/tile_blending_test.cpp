#include "preview/scene/tile_blending.h"

#include <gtest/gtest.h>

#include <cmath>

#include "preview/scene/material_texture.h"

namespace citykiln::preview {
namespace {

using materials::Material;

TEST(TileBlending, SharesAddUpToOneAndRepeatAfterThePeriod) {
  for (int i = 0; i < 200; ++i) {
    const Vec2 at{0.37 * i - 20, 0.91 * i - 50};
    const BlendedPatches here = patches_at(at, 4, 64);
    EXPECT_NEAR(here.shares[0] + here.shares[1] + here.shares[2], 1, 1e-9);
    for (const Vec2 off : {Vec2{64, 0}, Vec2{0, 64}, Vec2{-64, 128}}) {
      const BlendedPatches there = patches_at(at + off, 4, 64);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(there.shares[k], here.shares[k], 1e-6);
        EXPECT_EQ(there.offsets_m[k], here.offsets_m[k]);
      }
    }
  }
}

TEST(TileBlending, KeepsTheMeanAndTheContrastOfTheTexture) {
  for (const Material material : {Material::kAsphalt, Material::kGrass, Material::kGravel}) {
    const materials::Texture texture = materials::texture_of(material, 0.02, 1);
    const BlendedColours blended(texture.colour);
    const MipTexture plain(texture.colour, TexelMeaning::kColours, WrapMode::kRepeat);
    double mean[2] = {0, 0}, squares[2] = {0, 0};
    constexpr int kSide = 150;
    for (int i = 0; i < kSide * kSide; ++i) {
      const TextureFootprint footprint{{64.0 * (i % kSide) / kSide, 64.0 * (i / kSide) / kSide}, {}, 0.004, false};
      const double values[2] = {plain.mean(footprint)[1],
                                blended.mean(footprint, patches_at(footprint.centre, side_m(texture), 64))[1]};
      for (int k = 0; k < 2; ++k) mean[k] += values[k], squares[k] += values[k] * values[k];
    }
    for (int k = 0; k < 2; ++k) mean[k] /= kSide * kSide, squares[k] = squares[k] / (kSide * kSide) - mean[k] * mean[k];
    EXPECT_NEAR(mean[1] / mean[0], 1, 0.03) << values_of(material).name;
    EXPECT_NEAR(std::sqrt(squares[1] / squares[0]), 1, 0.15) << values_of(material).name;
  }
}

TEST(TileBlending, DoesNotRepeatAfterASide) {
  const materials::Texture texture = materials::texture_of(Material::kAsphalt, 0.02, 1);
  const MaterialTexture shown(texture);
  int alike = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec2 at{0.173 * i, 0.291 * i};
    const auto value = [&](Vec2 p) { return shown.colour({p, {}, 0.004, false})[1]; };
    alike += std::abs(value(at) - value(at + Vec2{side_m(texture), 0})) < 1e-4;
  }
  EXPECT_LT(alike, 20);
}

TEST(TileBlending, LeavesBricksInTheirCourses) {
  const materials::Texture texture = materials::texture_of(Material::kBrick, 0.02, 1);
  const MaterialTexture shown(texture);
  const MipTexture plain(texture.colour, TexelMeaning::kColours, WrapMode::kRepeat);
  for (int i = 0; i < 100; ++i) {
    const TextureFootprint footprint{{0.173 * i, 0.291 * i}, {}, 0.004, false};
    EXPECT_NEAR(shown.colour(footprint)[1] / (plain.mean(footprint)[1] * colour_factor(texture)[1]), 1, 0.1);
  }
}

}  // namespace
}  // namespace citykiln::preview
