// The atlases of several tiles as one, one above the other, and beside them what is too high for a column.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/atlas.h"

namespace citykiln::commands {

struct JoinedFacadeAtlases {
  impostor::Atlas atlas;
  /// What a place on one of the atlases becomes: at_m + scale · uv. Tiles of other tolerances have other texels.
  struct Place {
    Vec2 at_m;
    double scale = 1;
  };
  std::vector<Place> places;  ///< One an atlas.
};

/// Guarantees: every texel of every atlas is a texel of the joined one, at the place that its places become; atlases
/// without texels take no room. Where that would be more than a sheet may have, all are halved, each texel the mean of
/// four, in linear light, until it is not. O(texels).
///
/// @param atlases  In the order in which they are put down.
JoinedFacadeAtlases join_facade_atlases(std::span<const impostor::Atlas* const> atlases);

}  // namespace citykiln::commands
