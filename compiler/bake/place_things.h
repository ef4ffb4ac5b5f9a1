// Places the things of a tile on the ground.
#pragma once

#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/things/recipe.h"

namespace citykiln::bake {

/// A thing on the ground.
struct PlacedThing {
  things::Form form;
  Placement placement;
  int number = 1;  ///< The number of its form among those of its kind in the tile, from 1; the mesh is named by it.
};

/// Returns the things on the ground, in their order.
std::vector<PlacedThing> place_things(const std::vector<things::Thing>& things, const ground::GradedTerrain& graded);

/// The bounds of a thing: its box, turned in any way.
Bounds bounds_of(const PlacedThing& thing);

}  // namespace citykiln::bake
