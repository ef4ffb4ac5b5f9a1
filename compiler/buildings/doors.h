// Doors where a map tells of them: entrances, else house numbers, on a wall or close by it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// Entrances and addresses, by place.
struct MappedDoors {
  std::vector<Vec2> at;
  std::vector<bool> is_entrance;  ///< Else an address.
  BoxGrid grid;
};

MappedDoors index_doors(std::span<const map::PointFeature> points);

/// Of each edge of the outer ring, FacadeEdge::doors. A door is in the wall nearest to what tells of it, no farther
/// than 1.5 m, and not in walls that are too short for one. Where any entrance is, addresses do not count. O(edges
/// times points near).
std::vector<std::uint16_t> mapped_doors_by_edge(const Polygon& footprint, const MappedDoors& told);

/// Where the doors of a building are, plane metres, on its walls, at least kMinDoorToCorner_m from their ends.
std::vector<Vec2> door_positions(const Building& building);

/// Half a door's tile.
inline constexpr double kMinDoorToCorner_m = 1.25;

}  // namespace citykiln::buildings
