// Compares tiles inside of a cylinder with the tiles of the plane that they were made of.
#pragma once

#include "compiler/bake/baked_tile.h"
#include "compiler/map/plane/cylinder.h"

namespace citykiln::verify {

/// Returns the largest distance between a vertex of the plane's tile and that of the bent one, mapped back to the plane
/// by map::flattened(), which shares no code with the bending. Instances count by their place. Infinite if the bent
/// tile lacks a primitive, a vertex or an instance. Vertices that bending adds come last and are not compared. O(n).
double off_cylinder_m(const map::Cylinder& cylinder, const bake::BakedTile& plane, const bake::BakedTile& bent);

}  // namespace citykiln::verify
