// Places the things of a tile on the ground.
#pragma once

#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/things/recipe.h"

namespace citykiln::bake {

/// A thing where it stands. Things of one form show one mesh, as instances.
struct PlacedThing {
  things::Form form;
  Placement placement;     ///< The mesh's origin is the middle of the thing's base.
  int number = 1;          ///< The number of its form among the forms of its kind in the tile, from 1, in the order of
                           ///< Form. The name of the mesh has it.
  Vec3 up{0, 0, 1};        ///< The direction of the mesh's z axis, of unit length.
  bool is_parked = false;  ///< True for parked cars, street furniture and people, which are not recipes.
};

/// Returns the things of a tile with their placements (things::place()), one per thing, in their order: on the ground,
/// or at Thing::foot_m on a building; then the parked cars, the street furniture and the people. Mapped parking spaces are left
/// out. O(n log n).
/// @param cars    Results of place_cars(), place_furniture() and place_people().
/// @param graded  Must cover the bases of the things.
std::vector<PlacedThing> place_things(const std::vector<things::Thing>& things, const ground::GradedTerrain& graded,
                                      std::vector<PlacedThing> cars);

/// Returns bounds that contain a thing: in plan a square about its middle that holds its box at every turn, in height
/// from its foot to its top; wider if it is tilted. Plane metres.
Bounds bounds_of(const PlacedThing& thing);

}  // namespace citykiln::bake
