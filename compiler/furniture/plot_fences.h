// Decides where the fences of building sites and playgrounds of schools stand, and the cranes of sites.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/things/recipe.h"

namespace citykiln::furniture {

/// Returns the panels of mesh fence along the outer borders of a tile's building sites (2 m high), and along the sides
/// and the rear of playgrounds of schools (1.5 m). A panel stands only where urban or industrial land, grass or nothing
/// is mapped. Half of the sites of kLeastCraneSite_m2 or more have a crane, if one of 24 random places is free and 12 m
/// or more inside. A thing is in the tile that contains its middle. O(panels).
/// @param box  The tile.
std::vector<things::Thing> plot_fences(const roadside::TileRecipes& recipes, std::uint64_t seed, const Box2& box);

/// The least area of a site with a tower crane, in square metres.
inline constexpr double kLeastCraneSite_m2 = 1500;

}  // namespace citykiln::furniture
