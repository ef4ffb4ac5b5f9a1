// Places shop fronts: decides in which wall a shop, restaurant, office or workshop has its front, and how wide it is.
//
//      street
//   ───┬───────────┬─────┬────────┬───     Fronts on a stretch of wall have the order of their points. A stretch ends
//      │  front 1  │door │ front 2│        at corners, party walls and openings for ways, and beside mapped doors.
//      │     ×     │     │   ×    │        × points
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/meshes/passageways.h"
#include "compiler/buildings/planning/doors.h"
#include "compiler/buildings/planning/party_walls.h"
#include "compiler/buildings/planning/street_sides.h"
#include "compiler/buildings/recipe.h"
#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// The parts of the map that fronts are planned from; it owns none of them.
struct FrontSite {
  std::span<const map::Footprint> footprints;
  std::span<const std::vector<SharedWall>> shared_walls;  ///< One entry for each footprint.
  const Streets& streets;
  const MappedDoors& doors;
  std::span<const map::Passageway> passageways;  ///< Sorted by Passageway::building.
};

/// Returns one list of fronts for each footprint, sorted by edge, then from_m.
///
/// A point goes to a wall of the footprint that contains it: to the nearest one that faces a street, at most
/// kFrontInside_m away, else to the nearest one at most kNearWall_m away. Without such a wall it goes to a wall of a
/// footprint that does not contain it, at most kFrontOutside_m away: to the nearest one that faces a street, else to
/// the nearest one. An assumed point only goes to walls of its own footprint. Later planning treats an edge with a
/// front as one that faces a street.
///
/// All fronts on one stretch of wall have the same width, from kLeastFront_m to kWidestFront_m, and lie near their
/// points. If a building has no mapped door, its longest stretch that faces a street keeps kDoorTile_m free for a door,
/// if there is room. A point without a wall or without room gets no front. Mapped points are placed before assumed
/// ones.
///
/// Footprints for which may_have_fronts() is false have no fronts. The result does not depend on the order of the
/// points. Cannot fail. O(points · edges near).
///
/// @param points  Mapped and assumed ones (FrontPoint::is_assumed), plane metres.
/// @param report  Counts the mapped points in the account "buildings/front"; those that get no front are dropped there,
///                kNoWallForFront.
std::vector<std::vector<Front>> plan_fronts(std::span<const map::FrontPoint> points, const FrontSite& site,
                                            Report& report);

/// Returns true if a building on this footprint can have fronts: it stands on the ground, has walls, no parts and
/// at least 12 m², and is no hall, barn, garage, church, castle, hut or the like.
bool may_have_fronts(const map::Footprint& footprint);

/// Returns the parts of an edge of the outer ring in which fronts may be, in metres from its first point, ascending.
/// Party walls, openings for ways and the facade tiles of mapped doors are cut out.
/// @param doors  FacadeEdge::doors of the edge: a bit for each part of the edge with a mapped door.
std::vector<LinePart> free_parts(std::size_t footprint, std::size_t edge, std::uint16_t doors, const FrontSite& site);

/// The largest distance from a point to its wall: for a point inside the building and a wall that faces a street, for a
/// point outside, and for a point inside and a wall that faces no street.
inline constexpr double kFrontInside_m = 15, kFrontOutside_m = 1.5, kNearWall_m = 4;
/// The least and the largest width of a front, and the width of wall that a building's own door takes.
inline constexpr double kLeastFront_m = 2.5, kWidestFront_m = 12, kDoorTile_m = 2 * kMinDoorToCorner_m;

}  // namespace citykiln::buildings
