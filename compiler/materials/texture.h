// Textures of ground and walls: squares of a few metres that repeat both ways, with the material's colour and normals.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/materials/material.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::materials {

/// A common multiple of the periods of all textures. Texture coordinates are reduced by whole multiples of this length.
inline constexpr double kTexturePeriod_m = 64;
/// The grid step of texture coordinates, so that neighbouring tiles agree to the last bit in single precision, and in
/// 16 bits.
inline constexpr double kTextureCoordinateStep_m = 0x1p-8;

struct Texture {
  Material material{};
  TextureImage colour{};  ///< A square; empty if the material has one colour.
  /// A square of the same side in metres, or empty. Texels are (n + 1) / 2 · 255 of the unit normal's components along
  /// u, against v (up in the image) and outwards.
  TextureImage normal{};
  /// A square of the same side in metres, or empty: red is 255, green the roughness, blue the metalness, linear.
  TextureImage surface{};
  /// One per texel of `colour`, 0 to 255, if the texture has holes: texels below 128. Else empty.
  std::vector<std::uint8_t> opacity{};
  bool operator==(const Texture&) const = default;
};

/// A texture that tiles share and that does not change. Copies are cheap. References into it are valid as long as a
/// copy exists. Equal to another if their textures are: O(1) for copies, else O(texels).
class SharedTexture {
 public:
  explicit SharedTexture(Texture texture) : texture_(std::make_shared<const Texture>(std::move(texture))) {}
  // NOLINTNEXTLINE(google-explicit-constructor): what takes a texture takes a shared one
  operator const Texture&() const { return *texture_; }
  const Texture& operator*() const { return *texture_; }
  const Texture* operator->() const { return texture_.get(); }
  bool operator==(const SharedTexture& other) const {
    return texture_ == other.texture_ || *texture_ == *other.texture_;
  }

 private:
  std::shared_ptr<const Texture> texture_;
};

/// Returns the image of colours, or the image of normals if the material has one colour.
inline const TextureImage& shown_image(const Texture& texture) {
  return texture.colour.texels.empty() ? texture.normal : texture.colour;
}

/// Returns the period of a texture, metres.
double side_m(const Texture& texture);

/// True if a material has a texture at a tolerance: it has a row in texture_table.inc, and Detail::kMaterialTextures is
/// shown at the tolerance. A texture with holes is shown up to the tolerances of Detail::kFacadeTextures,
/// which replace its faces.
bool has_texture(Material material, double tolerance_m);

/// True if the texture of a material has normals at a tolerance: always for water, and for textures with relief if
/// Detail::kGroundNormals is shown at the tolerance.
bool has_normals(Material material, double tolerance_m);

/// True if the material's texture has holes. Faces are then seen from both sides.
bool has_holes(Material material);

/// True if the material's texture has no units that follow each other, such as bricks or waves: patches of it can be
/// blended anywhere.
bool has_no_units(Material material);

/// True if the texture shows the lanes of a street along v: patches of it can be blended if they move along v alone.
bool runs_along_lanes(Material material);

/// Returns the side of the material's texture, metres; 0 if it has none.
double texture_side_m(Material material);

/// True if a material is bark, which is wrapped around stems.
bool is_bark(Material material);

/// Returns the texture of a material. Precondition: has_texture(material, tolerance_m).
///
/// Guarantees: does not depend on the tolerance except by has_normals(), so that levels share it; the same bytes for
/// the same arguments on every CPU; repeats without a seam; at most 210 colours and 225 normals, so that palettes hold
/// them (water has more normals, since steps would be visible in reflections); the mean colour times colour_factor() is
/// the material's colour. O(texels): 20 to 110 ms for 512 × 512.
/// @param scale  Multiplies the texels of a side: a power of two, 1 for the table's sizes.
Texture texture_of(Material material, double tolerance_m, std::uint64_t seed, std::uint32_t scale = 1);

/// Returns the factor by which the texture's colours are multiplied so that their mean, in linear light, is the
/// material's colour: 0 … 1, near 1. For a texture without colours, returns the material's colour.
std::array<double, 3> colour_factor(const Texture& texture);

}  // namespace citykiln::materials
