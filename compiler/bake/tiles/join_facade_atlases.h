// Joins the facade atlases of several tiles to one. Atlases are stacked in columns; each column is as high as an image
// may be.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/atlas.h"

namespace citykiln::bake {

/// The joined atlas, and where each input is in it.
struct JoinedFacadeAtlases {
  impostor::Atlas atlas;
  /// The transform of an input's texture coordinates: at_m + scale · uv. The scale is not 1 for inputs with another
  /// texel size.
  struct Place {
    Vec2 at_m;
    double scale = 1;
  };
  std::vector<Place> places;  ///< One per input.
};

/// Joins atlases in the given order.
///
/// Guarantees: every texel of every atlas is a texel of the joined one, at its transformed place. Atlases without
/// texels take no space. If the result would exceed the size limits of an image, all atlases are halved until it fits;
/// each texel is then the mean of four in linear light. O(texels).
JoinedFacadeAtlases join_facade_atlases(std::span<const impostor::Atlas* const> atlases);

}  // namespace citykiln::bake
