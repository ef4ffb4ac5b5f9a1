// Decides what stands in the yards of houses: gates, bins, sheds, pools, terraces, vegetable beds, washing lines.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/lots/recipe.h"
#include "compiler/plants/recipe.h"
#include "compiler/things/recipe.h"

namespace citykiln::furniture {

/// The recipes of a tile.
struct YardRecipes {
  std::span<const lots::Yard> yards;
  std::span<const plants::Tree> trees;       ///< Their trunks are kept clear.
  const ground::LandCoverIndex& land_cover;  ///< With the areas of yards.
};

/// Returns the things in the yards of detached and row houses. Each yard draws its kinds by the shares of
/// things/yard_kinds.inc, and up to 12 places for each: the first that is free is taken, else the yard has none. A
/// place
///
/// - lies wholly on lawn, gravel, earth or paving of its own yard, off paths and drives;
/// - keeps 0.75 m from buildings, trunks and other things of the yard; bins stand at a wall instead.
///
/// Gates stand where a path or drive leaves a yard that has a wall or fence along the street, in six yards of ten; they
/// are as high as the barrier.
///
/// A thing is in the tile that contains its middle. Trees of other tiles do not count. O(yards · places · trees near).
/// @param box  The tile.
std::vector<things::Thing> yard_things(const YardRecipes& recipes, std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
