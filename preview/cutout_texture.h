// A cutout as rays see it: colour and normal, smoothed as far as what a ray covers, and where there is nothing.
#pragma once

#include <optional>

#include "compiler/impostor/cutout.h"
#include "preview/mip_texture.h"

namespace citykiln::preview {

/// Refers to the cutout, which must outlive it. Smoothed to its second mip level, as an atlas is.
class CutoutTexture {
 public:
  /// @param cutout  With texels.
  explicit CutoutTexture(const impostor::Cutout& cutout);

  /// Opacity between the middles of four texels, at least kAlphaCutoff. Single rays ask: many of them see the mean.
  bool is_there(Vec2 at_m) const;
  /// Linear reflectance, mean over a patch.
  std::array<double, 3> colour(const TextureFootprint& patch) const { return colour_.mean(patch); }
  /// Unit: along u, against v, outwards.
  Vec3 normal(const TextureFootprint& patch) const;
  bool has_normals() const { return normal_.has_value(); }

 private:
  double opacity(std::int64_t column, std::int64_t row) const;

  const impostor::Cutout* cutout_;
  MipTexture colour_;
  std::optional<MipTexture> normal_;
};

}  // namespace citykiln::preview
