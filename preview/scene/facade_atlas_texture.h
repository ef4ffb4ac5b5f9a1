// A facade atlas (an image of many small pictures of walls) for rays: colour, roughness, metalness, emission and
// normal, filtered over the ray's footprint. A footprint is the part of an image that a ray covers.
#pragma once

#include <optional>
#include <utility>

#include "compiler/impostor/atlas.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// The textures of a facade atlas. Refers to the atlas, which must outlive this object. Filters stay within one picture
/// of the atlas, and use at most the second mip level, on which pictures do not mix yet: so a face looks the same on
/// any atlas.
class FacadeAtlasTexture {
 public:
  /// @param atlas  Has texels.
  explicit FacadeAtlasTexture(const impostor::Atlas& atlas);

  const impostor::Atlas& atlas() const { return *atlas_; }
  /// Returns the mean linear reflectance over a footprint.
  /// @param picture  The texels of the picture that contains the footprint.
  std::array<double, 3> colour(const TextureFootprint& footprint, const TexelRectangle& picture) const {
    return colour_.mean(footprint, picture);
  }
  /// Returns the mean linear emission as a share of materials::kEmission_cd_m2.
  std::array<double, 3> emission(const TextureFootprint& footprint, const TexelRectangle& picture) const {
    return emission_ ? emission_->mean(footprint, picture) : std::array<double, 3>{};
  }
  /// Returns the unit normal over a footprint, in the frame of the picture: its components are along u, against v
  /// (upwards in the picture), and outwards from the wall. Precondition: has_normals().
  Vec3 normal(const TextureFootprint& footprint, const TexelRectangle& picture) const;
  bool shines() const { return emission_.has_value(); }
  bool has_normals() const { return normal_.has_value(); }
  std::size_t bytes() const;  ///< The bytes of the textures with their images.
  /// Returns the mean roughness and metalness, in [0, 1].
  std::pair<float, float> surface(const TextureFootprint& footprint, const TexelRectangle& picture) const {
    const auto mean = surface_.mean(footprint, picture);
    return {static_cast<float>(mean[1]), static_cast<float>(mean[2])};
  }

 private:
  const impostor::Atlas* atlas_;
  MipTexture colour_, surface_;
  std::optional<MipTexture> emission_, normal_;
};

}  // namespace citykiln::preview
