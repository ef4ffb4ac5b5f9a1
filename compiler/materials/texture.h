// Textures of the ground and of walls: squares of a few metres that repeat both ways. A picture of the material's
// colour, and where the shape is seen, one of its normals.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/materials/material.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::materials {

/// Whatever repeats also does so after this: places on textures are told by less than it and a triangle.
inline constexpr double kTexturePeriod_m = 64;
/// Places on textures are multiples of this, so that neighbouring tiles agree to the last bit on single precision, and
/// on 16 bits.
inline constexpr double kTextureCoordinateStep_m = 0x1p-8;

struct Texture {
  Material material{};
  TextureImage colour{};  ///< A square; without texels: the material's one colour.
  /// A square of the same side, or none. Texels are (n + 1) / 2 · 255 of the unit normal's part along u, against v (up,
  /// as pictures have it) and outwards.
  TextureImage normal{};
  bool operator==(const Texture&) const = default;
};

/// Metres after which it repeats.
double side_m(const Texture& texture);

/// Bark is looked at from nearer than all else that is as fine: its texels may be so much smaller than the tolerance.
inline constexpr double kBarkTexelsPerTolerance = 8;

/// Does the material have one at this tolerance, which must have Detail::kMaterialTextures? Its texels are at least as
/// large as the tolerance; of bark, as an eighth of it.
bool has_texture(Material material, double tolerance_m);

/// The side of the material's texture, metres; 0: it has none.
double texture_side_m(Material material);

/// Is it bark, which has its texture around stems?
bool is_bark(Material material);

/// The texture of a material that has one.
///
/// Guarantees: the same bytes for the same arguments, on every CPU; repeats without a seam; at most 16 colours, or 225
/// normals, so that a PNG is small (water, where steps would be seen in mirrors: more); mean(texture) times
/// colour_factor is the material's own colour. O(texels): some 10 ms.
Texture texture_of(Material material, double tolerance_m, std::uint64_t seed);

/// Of each of the materials, each once and rising, that has one.
std::vector<Texture> textures_of(std::span<const Material> materials, double tolerance_m, std::uint64_t seed);

/// What the texture's colours are multiplied by so that their mean, in linear light, is the material's colour: 0 … 1,
/// near 1. The material's colour itself where there are no texels.
std::array<double, 3> colour_factor(const Texture& texture);

}  // namespace citykiln::materials
