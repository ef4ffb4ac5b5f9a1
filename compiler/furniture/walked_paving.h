// Tests whether a place is paving on which people walk.
#pragma once

#include "compiler/roadside/tile_recipes.h"

namespace citykiln::furniture {

/// True on pavements, streets for walkers, squares and paved footways; false beyond the tile's land cover. O(1)
/// expected.
inline bool is_walked_paving(const roadside::TileRecipes& recipes, Vec2 p) {
  using enum map::LandCoverClass;
  if (!recipes.land_cover.box.contains(p)) return false;
  const std::uint32_t top = ground::land_cover_at(recipes.land_cover, p);
  if (top == ground::kNoLandCover) return false;
  const map::LandCoverClass surface = recipes.land_cover.surfaces[top].surface;
  return surface == kPavement || surface == kPedestrianStreet || surface == kSquare || surface == kPavedFootPath;
}

}  // namespace citykiln::furniture
