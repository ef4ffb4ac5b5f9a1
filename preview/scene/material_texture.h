// A material's texture for rays: colour, normal and roughness, filtered over the ray's footprint.
#pragma once

#include <optional>

#include "compiler/materials/texture.h"
#include "preview/scene/mip_texture.h"
#include "preview/scene/tile_blending.h"

namespace citykiln::preview {

/// The textures of a material. Refers to the texture, which must outlive this object. Water has no normals here, since
/// its waves (water_waves.h) never repeat. Patterns without units, such as gravel, do not repeat either: patches of
/// them are blended (tile_blending.h), of lanes along these. Patterns with units, such as bricks, repeat, and vary in
/// brightness over metres.
class MaterialTexture {
 public:
  explicit MaterialTexture(const materials::Texture& texture);

  const materials::Texture& texture() const { return *texture_; }
  /// Returns the mean linear reflectance over a footprint, which is the part of an image that a ray covers. The mean
  /// over the plane is the material's colour.
  /// @param period_m  The length after which texture coordinates may jump back.
  std::array<double, 3> colour(const TextureFootprint& footprint, double period_m = materials::kTexturePeriod_m) const;
  /// Returns the unit normal over a footprint: its components along u, against v, and outwards.
  Vec3 normal(const TextureFootprint& footprint, double period_m = materials::kTexturePeriod_m) const;
  /// Returns the roughness over a footprint.
  double roughness(const TextureFootprint& footprint, double period_m = materials::kTexturePeriod_m) const;
  bool has_normals() const { return normal_.has_value(); }
  bool has_holes() const { return !texture_->opacity.empty(); }
  /// True if there is no hole at a point: the opacity, interpolated between four texels, is at least 127.5.
  /// @param at_m  Metres on the texture, which repeats. Requires has_holes().
  bool is_there(Vec2 at_m) const;
  std::size_t bytes() const;  ///< The bytes of the textures with their images.

 private:
  BlendedPatches patches(const TextureFootprint& footprint, double period_m) const;

  const materials::Texture* texture_;
  std::array<double, 3> factor_;
  std::optional<MipTexture> colour_, normal_, surface_;
  std::optional<BlendedColours> blended_;
};

}  // namespace citykiln::preview
