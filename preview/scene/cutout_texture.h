// A cutout for rays: colour and normal, filtered over the ray's footprint, and its holes.
#pragma once

#include <optional>

#include "compiler/impostor/cutout.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// The textures of a cutout. Refers to the cutout, which must outlive it. Filtered up to its second mip level, like
/// facade atlases.
class CutoutTexture {
 public:
  /// @param cutout  Has texels.
  explicit CutoutTexture(const impostor::Cutout& cutout);

  /// True if the opacity, interpolated between four texels, is at least impostor::kAlphaCutoff: the alpha test for one
  /// ray. The average over many rays is the coverage.
  bool is_there(Vec2 at_m) const;
  /// The mean linear reflectance over a footprint.
  std::array<double, 3> colour(const TextureFootprint& footprint) const { return colour_.mean(footprint); }
  /// The unit normal: along u, against v, outwards.
  Vec3 normal(const TextureFootprint& footprint) const;
  bool has_normals() const { return normal_.has_value(); }
  const impostor::Cutout& cutout() const { return *cutout_; }
  std::size_t bytes() const;  ///< Textures with their images.

 private:
  double opacity(std::int64_t column, std::int64_t row) const;

  const impostor::Cutout* cutout_;
  MipTexture colour_;
  std::optional<MipTexture> normal_;
};

}  // namespace citykiln::preview
