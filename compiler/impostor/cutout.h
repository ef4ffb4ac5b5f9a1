// Cutouts: atlases of pictures with opacity, packed side by side, for cards: rectangles with an alpha-tested picture of
// leaves.
//
//     +-------------+-------------+    each picture lies in a cell of its own. The sides of cells
//     | . . . . . . | . . . . . . |    are multiples of 16 texels or more, so no texel of mip levels
//     | . pictu . . | . picture . |    0 to 4 mixes two pictures
//     | . . . . . . | . . . . . . |
//     +-------------+-------------+
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/mip_opacity.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// A cutout: one atlas, as several images. Unlike textures of materials, the images are not repeated.
struct Cutout {
  materials::TextureImage colour{};     ///< sRGB reflectance.
  std::vector<std::uint8_t> opacity{};  ///< One per texel of `colour`.
  /// Normals in the format of materials::Texture::normal, with a texel size of their own; may be empty.
  materials::TextureImage normal{};
  bool operator==(const Cutout&) const = default;
};

/// A cutout that many meshes share. Compared by value. By default it has no texels.
class SharedCutout {
 public:
  SharedCutout() : SharedCutout(Cutout{}) {}
  SharedCutout(Cutout cutout) : cutout_(std::make_shared<const Cutout>(std::move(cutout))) {}  // NOLINT: implicit

  const Cutout& operator*() const { return *cutout_; }
  const Cutout* operator->() const { return cutout_.get(); }
  bool operator==(const SharedCutout& other) const { return cutout_ == other.cutout_ || *cutout_ == *other.cutout_; }

 private:
  std::shared_ptr<const Cutout> cutout_;
};

/// A cutout, and where each picture is in it.
struct CutoutLayout {
  Cutout cutout;           ///< The atlas.
  std::vector<Vec2> at_m;  ///< The position of each picture's u = v = 0 in the atlas, in metres.
};

/// The sides of cells are multiples of kCell_px texels, or of a larger power of two up to kWideCell_px if that takes no
/// more texels.
inline constexpr std::uint32_t kCell_px = 16, kWideCell_px = 64;

/// Packs pictures, without normals, and gives them opacities that survive mip levels (mip_opacity.h). Positions in the
/// result are in the order of `pictures`.
///
/// @param pictures  Each has at least one texel. They are halved until the image has at most kMaxAtlasTexels.
/// @param texel_m   The side of a texel of the pictures in metres, > 0. It doubles when pictures are halved.
///
/// Guarantees: the sides of the image are powers of two. Texels around a picture are transparent, or opaque if the
/// picture is covered completely. Texels without coverage have the mean colour of their picture, so filtering adds no
/// dark fringe. O(n log n + texels).
CutoutLayout lay_out_cutout(std::vector<Picture> pictures, double texel_m);

}  // namespace citykiln::impostor
