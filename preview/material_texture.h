// A material's texture as rays see it: its colour and its normal, smoothed as far as what a ray covers.
#pragma once

#include <optional>

#include "compiler/materials/texture.h"
#include "preview/mip_texture.h"

namespace citykiln::preview {

/// Refers to the texture, which must outlive it. Water's normals are left out: waves (water.h) never repeat.
class MaterialTexture {
 public:
  explicit MaterialTexture(const materials::Texture& texture);

  const materials::Texture& texture() const { return *texture_; }
  /// Linear reflectance, mean over a patch: over all of it, the material's own colour.
  std::array<double, 3> colour(const TextureFootprint& patch) const;
  /// Unit: along u, against v, outwards.
  Vec3 normal(const TextureFootprint& patch) const;
  bool has_normals() const { return normal_.has_value(); }

 private:
  const materials::Texture* texture_;
  std::array<double, 3> factor_;
  std::optional<MipTexture> colour_, normal_;
};

}  // namespace citykiln::preview
