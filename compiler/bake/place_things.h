// Places the things of a tile on the ground.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/things/recipe.h"

namespace citykiln::bake {

/// Where a thing comes from: a recipe, or what is drawn when a tile is baked.
enum class ThingSource : std::uint8_t { kRecipe, kCar, kFurniture, kPerson, kCount };

/// A thing where it stands. Things of one form show one mesh, as instances.
struct PlacedThing {
  things::Form form;
  Placement placement;  ///< The mesh's origin is the middle of the thing's base.
  int number = 1;       ///< The number of its form among the forms of its kind in the tile, from 1, in the order of
                        ///< Form. The name of the mesh has it.
  Vec3 up{0, 0, 1};     ///< The direction of the mesh's z axis, of unit length.
  ThingSource source = ThingSource::kRecipe;
};

/// Returns the things of a tile with their placements (things::place()), one per thing, in their order: on the ground,
/// or at Thing::foot_m on a building; then what is drawn. Mapped parking spaces are left out. O(n log n).
/// @param drawn   Results of place_generated() and place_people().
/// @param graded  Must cover the bases of the things.
std::vector<PlacedThing> place_things(const std::vector<things::Thing>& things, const ground::GradedTerrain& graded,
                                      std::vector<PlacedThing> drawn);

/// Returns bounds that contain a thing: in plan a square about its middle that holds its box at every turn, in height
/// from its foot to its top; wider if it is tilted. Plane metres.
Bounds bounds_of(const PlacedThing& thing);

}  // namespace citykiln::bake
