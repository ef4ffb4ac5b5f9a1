// Decides where the fences of building sites and playgrounds of schools stand, and the cranes of sites.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/things/recipe.h"

namespace citykiln::furniture {

/// Returns the panels of mesh fence along the borders of a tile's building sites, and along the sides and the rear of
/// playgrounds of schools. A panel is left out where it would stand on a way, on water, in a building or in mapped
/// ground of another kind. Sites of more than kLeastCraneSite_m2 have a crane with a chance of 1/2, 12 m or more
/// inside. A thing is in the tile that contains its middle. O(panels).
/// @param box  The tile.
std::vector<things::Thing> plot_fences(const roadside::TileRecipes& recipes, std::uint64_t seed, const Box2& box);

/// Smaller sites have no tower crane, in square metres.
inline constexpr double kLeastCraneSite_m2 = 1500;

}  // namespace citykiln::furniture
