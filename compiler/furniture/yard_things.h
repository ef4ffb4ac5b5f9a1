// Decides what stands in the yards of houses: gates, bins, garages, carports, sheds, pools, terraces, vegetable beds,
// washing lines.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/things/recipe.h"

namespace citykiln::furniture {

/// Returns the things in yards and on plots. Each garden of a detached or row house draws its kinds by the shares of
/// things/yard_kinds.inc, and up to 12 places for each: the first that is free is taken, else the yard has none. A
/// place
///
/// - of a garage is behind the inner end of a drive, that of a carport over it, where that is open ground of the yard;
/// - else lies wholly on lawn, gravel, earth or paving of its own yard, off paths and drives;
/// - keeps 0.75 m from buildings, trunks and other things of the yard; bins stand at a wall instead.
///
/// Other yards and plots draw a number of each kind by their use (things/yard_number()), and up to 24 places for each,
/// also on asphalt. On plots a place lies on land use that no lot has. Some kinds stand along the border.
///
/// Gates stand where a path or drive leaves a yard that has a wall or fence along the street, in six yards of ten; they
/// are as high as the barrier.
///
/// A thing is in the tile that contains its middle. Trees of other tiles do not count. O(yards · places · trees near).
/// @param zones  clear_zones_of() the recipes.
/// @param box    The tile.
std::vector<things::Thing> yard_things(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
