// A material's texture as rays see it: its colour and its normal, smoothed as far as what a ray covers.
#pragma once

#include <optional>

#include "compiler/materials/texture.h"
#include "preview/sheet_texture.h"

namespace citykiln::preview {

/// Refers to the texture, which must outlive it. Water's normals are left out: waves (water.h) never repeat.
class SurfaceTexture {
 public:
  explicit SurfaceTexture(const materials::Texture& texture);

  const materials::Texture& texture() const { return *texture_; }
  /// Linear reflectance, mean over a patch: over all of it, the material's own colour.
  std::array<double, 3> colour(const Patch& patch) const;
  /// Unit: along u, against v, outwards.
  Vec3 normal(const Patch& patch) const;
  bool has_normals() const { return normal_.has_value(); }

 private:
  const materials::Texture* texture_;
  std::array<double, 3> factor_;
  std::optional<SheetTexture> colour_, normal_;
};

}  // namespace citykiln::preview
