// Places doors at mapped entrances, or at house numbers if no entrance is mapped.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// Mapped entrances and addresses, with a spatial index.
struct MappedDoors {
  std::vector<Vec2> at;           ///< Plane metres.
  std::vector<bool> is_entrance;  ///< True: an entrance. False: an address.
  BoxGrid grid;
};

/// Returns the entrances and addresses among the points of a map.
MappedDoors index_doors(std::span<const map::PointFeature> points);

/// Returns FacadeEdge::doors for each edge of the outer ring. A door lies in the edge nearest to its point and at most
/// 1.5 m away, among edges long enough for a door. Addresses count only if the building has no entrance. O(edges ·
/// points near).
std::vector<std::uint16_t> mapped_doors_by_edge(const Polygon& footprint, const MappedDoors& doors);

/// Returns the distances along an edge of its doors, ascending, at least kMinDoorToCorner_m from its ends; none if the
/// edge is shorter than a door's tile.
/// @param doors  FacadeEdge::doors.
std::vector<double> door_places_m(std::uint16_t doors, double length_m);

/// Returns the positions of a building's doors on its walls, plane metres, at least kMinDoorToCorner_m from the ends of
/// the edge.
std::vector<Vec2> door_positions(const Building& building);

/// Half the width of the facade tile that contains a door.
inline constexpr double kMinDoorToCorner_m = 1.25;

}  // namespace citykiln::buildings
