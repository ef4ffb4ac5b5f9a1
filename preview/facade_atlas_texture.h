// An atlas of imprints as rays see it: colour, roughness, emission and normal, smoothed as far as what a ray covers.
#pragma once

#include <optional>

#include "compiler/impostor/atlas.h"
#include "preview/mip_texture.h"

namespace citykiln::preview {

/// Refers to the atlas, which must outlive it. It is smoothed down to its second mip level, where its pictures are
/// still apart; what covers more of it is what a coarser level is for.
class FacadeAtlasTexture {
 public:
  /// @param atlas  With texels.
  explicit FacadeAtlasTexture(const impostor::Atlas& atlas);

  const impostor::Atlas& atlas() const { return *atlas_; }
  /// Linear reflectance, mean over a patch.
  std::array<double, 3> colour(const TextureFootprint& patch) const { return colour_.mean(patch); }
  /// Linear emission, of materials::kEmission_cd_m2.
  std::array<double, 3> emission(const TextureFootprint& patch) const {
    return emission_ ? emission_->mean(patch) : std::array<double, 3>{};
  }
  /// Unit: along u, against v, outwards.
  Vec3 normal(const TextureFootprint& patch) const;
  bool has_normals() const { return normal_.has_value(); }
  float roughness(const TextureFootprint& patch) const { return static_cast<float>(surface_.mean(patch)[1]); }

 private:
  const impostor::Atlas* atlas_;
  MipTexture colour_, surface_;
  std::optional<MipTexture> emission_, normal_;
};

}  // namespace citykiln::preview
