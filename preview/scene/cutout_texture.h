// A cutout (a flat image with holes, such as a card of leaves) for rays: colour and normal, filtered over the ray's
// footprint, and the holes.
#pragma once

#include <optional>

#include "compiler/impostor/cutout.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// The textures of a cutout. Refers to the cutout, which must outlive this object. At most the second mip level is
/// used.
class CutoutTexture {
 public:
  /// @param cutout  Has texels.
  explicit CutoutTexture(const impostor::Cutout& cutout);

  /// True if the cutout has no hole at a point: the opacity, interpolated between four texels, is at least
  /// impostor::kAlphaCutoff - 0.5.
  /// @param at_m  Metres on the image.
  bool is_there(Vec2 at_m) const;
  /// Returns the mean linear reflectance over a footprint.
  std::array<double, 3> colour(const TextureFootprint& footprint) const { return colour_.mean(footprint); }
  /// Returns the unit normal over a footprint: its components along u, against v, and outwards. Requires has_normals().
  Vec3 normal(const TextureFootprint& footprint) const;
  bool has_normals() const { return normal_.has_value(); }
  const impostor::Cutout& cutout() const { return *cutout_; }
  std::size_t bytes() const;  ///< The bytes of the textures with their images.

 private:
  double opacity(std::int64_t column, std::int64_t row) const;

  const impostor::Cutout* cutout_;
  MipTexture colour_;
  std::optional<MipTexture> normal_;
};

}  // namespace citykiln::preview
