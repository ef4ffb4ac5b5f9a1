// Tests whether a curve comes too near to buildings or to other ways.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The distance in metres from a chord within which a building means that the chord is in a town.
inline constexpr double kInTown_m = 32;

/// The outer outlines of buildings, with a grid that finds them. They refer to footprints that must
/// outlive them.
struct BuildingOutlines {
  std::vector<const map::Footprint*> footprints;
  BoxGrid grid;
};

/// Returns the outlines of all footprints that are not building parts. O(n).
BuildingOutlines building_outlines(std::span<const map::Footprint> footprints);

/// True if the bounding box of a building is within kInTown_m of the bounding box of the chord from
/// a to b.
bool is_in_town(const BuildingOutlines& walls, Vec2 a, Vec2 b);

/// True if the curve is at least half_m, in metres, from each building, or as near to it as the
/// chord is (to 5 cm). O(outlines near it).
/// @param curve  Points from one end of the chord to its other, both included.
bool has_room_between(const BuildingOutlines& walls, const Polyline& curve, double half_m);

/// The segments of axes of ways on the ground, with a grid that finds them. They refer to tracks
/// that must outlive them.
struct WayPieces {
  /// A track, and the index of the first point of a segment.
  std::vector<std::pair<const map::Track*, std::size_t>> pieces;
  BoxGrid grid;
  double widest_m = 0;  ///< The largest distance of an edge of a way from its axis, with pavements.
};

/// Returns the segments of all ways on the ground that are not indoors. O(n).
WayPieces pieces_of_ways(std::span<const map::Track> tracks);

/// Returns false if a pavement is assumed on this or another way, and their strips would overlap: it
/// would lie in the other. Segments that meet the chord at its ends overlap anyway: these count if
/// the curve is nearer to them than the chord, by more than 5 cm. Segments of the same way do not
/// count. O(segments near it).
bool keeps_off_other_ways(const WayPieces& ways, const map::Track& track, const Polyline& curve);

}  // namespace citykiln::assume
