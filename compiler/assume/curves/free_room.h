// Finds buildings that a curve would come too near to.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// A chord is in a town if a building is nearer than this.
inline constexpr double kInTown_m = 32;

/// The outlines of buildings on the ground, with a grid that finds them. Refers to footprints that must outlive it.
struct Walls {
  std::vector<const map::Footprint*> footprints;
  BoxGrid grid;
};

/// Returns the walls of all footprints but parts. O(n).
Walls walls_of(std::span<const map::Footprint> footprints);

/// True if the box of a footprint is nearer than kInTown_m to the chord's box.
bool is_in_town(const Walls& walls, Vec2 a, Vec2 b);

/// True if a line keeps a distance of half_m from all walls, except where its chord comes as near. O(walls near it).
/// @param curve  From one end of the chord to its other.
bool has_room_between(const Walls& walls, const Polyline& curve, double half_m);

}  // namespace citykiln::assume
