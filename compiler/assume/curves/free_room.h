// Finds buildings that a curve would come too near to.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
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

/// The pieces of axes of ways on the ground, with a grid that finds them. Refers to tracks that must outlive it.
struct WayPieces {
  std::vector<std::pair<const map::Track*, std::size_t>> pieces;  ///< A track, and the first point of the piece.
  BoxGrid grid;
  double widest_m = 0;  ///< The largest distance of an edge from its axis.
};

/// Returns the pieces of all ways on the ground that are not indoors. O(n).
WayPieces pieces_of_ways(std::span<const map::Track> tracks);

/// Returns false if a curve brings the way nearer to another one than its chord does, so that a pavement which is
/// assumed of either would lie in the other. O(pieces near it).
bool keeps_pavements(const WayPieces& ways, const map::Track& track, const Polyline& curve);

}  // namespace citykiln::assume
