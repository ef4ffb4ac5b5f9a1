// Places shop fronts: decides which wall a shop, restaurant, office or workshop stands behind, and how wide its front
// is.
//
//      street
//   ───┬───────────┬─────┬────────┬───     Fronts share a stretch of wall in the order of their points. A stretch ends
//      │  front 1  │door │ front 2│        at corners, party walls and openings for ways, and beside mapped doors.
//      │     ×     │     │   ×    │        × points
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/doors.h"
#include "compiler/buildings/party_walls.h"
#include "compiler/buildings/passageways.h"
#include "compiler/buildings/recipe.h"
#include "compiler/buildings/street_sides.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// The indexes of the map that fronts are planned from.
struct FrontSite {
  std::span<const map::Footprint> footprints;
  std::span<const std::vector<SharedWall>> shared_walls;  ///< By footprint.
  const Streets& streets;
  const MappedDoors& doors;
  std::span<const map::Passageway> passageways;  ///< Sorted by building.
};

/// Returns the fronts of each footprint, sorted by edge, then from_m.
///
/// A point belongs to the footprint that contains it, else to the nearest at most kFrontOutside_m away. It goes to the
/// nearest wall that faces a street, at most kFrontInside_m away; without one, to the nearest wall at most kNearWall_m
/// away, which then counts as facing a street. Fronts on one stretch of wall have equal widths, from kLeastFront_m to
/// kWidestFront_m. On the longest stretch of a building without mapped doors, kDoorTile_m stay free for its door if
/// there is room. Points for which there is no wall or no room are dropped (kNoWallForFront), apart from assumed ones.
///
/// Halls, barns, garages, churches, castles, huts, roofs and what does not stand on the ground have no fronts. Counts
/// mapped points in the ledger "buildings/front". The result does not depend on the order of the points. O(points ·
/// edges near).
std::vector<std::vector<Front>> plan_fronts(std::span<const map::FrontPoint> points, const FrontSite& site,
                                            Report& report);

/// True if a building on this footprint can have fronts.
bool may_have_fronts(const map::Footprint& footprint);

/// Returns the parts of an edge of the outer ring where fronts may be, as distances along it: without party walls,
/// openings for ways, and the tiles of mapped doors.
/// @param doors  FacadeEdge::doors of the edge.
std::vector<LinePart> free_parts(std::size_t footprint, std::size_t edge, std::uint16_t doors, const FrontSite& site);

/// The largest distances of a point from its wall: inside the building, outside of it, and from a wall that faces no
/// street.
inline constexpr double kFrontInside_m = 15, kFrontOutside_m = 1.5, kNearWall_m = 4;
/// The least and the largest width of a front, and the width of wall that a building's own door takes.
inline constexpr double kLeastFront_m = 2.5, kWidestFront_m = 12, kDoorTile_m = 2.5;

}  // namespace citykiln::buildings
