#include "compiler/materials/texture_cache.h"

#include <gtest/gtest.h>

#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::materials {
namespace {

std::vector<SharedTexture> drawn_without_cache(std::span<const Material> materials, double tolerance_m,
                                               std::uint64_t seed) {
  std::vector<SharedTexture> textures;
  for (const Material material : materials)
    if (has_texture(material, tolerance_m)) textures.emplace_back(texture_of(material, tolerance_m, seed));
  return textures;
}

TEST(TextureCache, ReturnsTheTexturesOfItsArguments) {
  const TextureCache cache(3);
  const std::vector<Material> materials = {Material::kGrass, Material::kWater, Material::kGlass, Material::kAsphalt};
  for (const double tolerance_m : {0.02, 0.1, 0.02, 0.5}) {
    const auto fewer = std::span(materials).subspan(1);
    EXPECT_EQ(cache.textures_of(materials, tolerance_m).size(), tolerance_m < 0.25 ? 3u : 0u);
    EXPECT_EQ(cache.textures_of(materials, tolerance_m), drawn_without_cache(materials, tolerance_m, 3));
    EXPECT_EQ(cache.textures_of(fewer, tolerance_m), drawn_without_cache(fewer, tolerance_m, 3));
  }
}

TEST(TextureCache, PrefersTexturesOfItsOwner) {
  Texture own = texture_of(Material::kBrick, 0.05, 3);
  own.colour.texels.assign(own.colour.texels.size(), {1, 2, 3});
  const TextureCache cache(3, 1, {own});
  EXPECT_EQ(cache.texture(Material::kBrick, 0.05)->colour, own.colour);
  EXPECT_EQ(cache.texture(Material::kSlate, 0.05), texture_of(Material::kSlate, 0.05, 3));
  EXPECT_TRUE(cache.texture(Material::kBrick, 0.1)->normal.texels.empty());
}

TEST(TextureCache, IsThreadSafe) {
  const TextureCache cache(1);
  const std::vector<Material> materials = {Material::kGrass, Material::kAsphalt};
  const auto drawn = drawn_without_cache(materials, 0.1, 1);
  const auto taken =
      for_each_slot<std::vector<SharedTexture>>(32, 8, [&](std::size_t) { return cache.textures_of(materials, 0.1); });
  ASSERT_EQ(taken.size(), 32u);
  ASSERT_EQ(drawn.size(), 2u);
  for (const std::vector<SharedTexture>& each : taken) EXPECT_EQ(each, drawn);
}

}  // namespace
}  // namespace citykiln::materials
