// A material's texture for rays: colour and normal, filtered over the ray's footprint.
#pragma once

#include <optional>

#include "compiler/materials/texture.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// The textures of a material. Refers to the texture, which must outlive it. Normals of water are left out, since its
/// waves (water_waves.h) never repeat.
class MaterialTexture {
 public:
  explicit MaterialTexture(const materials::Texture& texture);

  const materials::Texture& texture() const { return *texture_; }
  /// The mean linear reflectance over a footprint; over the whole texture it is the material's colour.
  std::array<double, 3> colour(const TextureFootprint& footprint) const;
  /// The unit normal: along u, against v, outwards.
  Vec3 normal(const TextureFootprint& footprint) const;
  bool has_normals() const { return normal_.has_value(); }
  std::size_t bytes() const;  ///< Textures with their images.

 private:
  const materials::Texture* texture_;
  std::array<double, 3> factor_;
  std::optional<MipTexture> colour_, normal_;
};

}  // namespace citykiln::preview
