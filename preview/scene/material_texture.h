// A material's texture as rays see it: colour and normal, filtered over the ray's footprint.
#pragma once

#include <optional>

#include "compiler/materials/texture.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// Refers to the texture, which must outlive it. Normals of water are left out, since its waves (water_waves.h) never
/// repeat.
class MaterialTexture {
 public:
  explicit MaterialTexture(const materials::Texture& texture);

  const materials::Texture& texture() const { return *texture_; }
  /// Mean linear reflectance over a footprint; over the whole texture it is the material's colour.
  std::array<double, 3> colour(const TextureFootprint& footprint) const;
  /// Unit normal: along u, against v, outwards.
  Vec3 normal(const TextureFootprint& footprint) const;
  bool has_normals() const { return normal_.has_value(); }
  std::size_t bytes() const;  ///< With the images.

 private:
  const materials::Texture* texture_;
  std::array<double, 3> factor_;
  std::optional<MipTexture> colour_, normal_;
};

}  // namespace citykiln::preview
