// Decides where the sea and wide lakes go on around the extent.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/surroundings/coast_sides.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// The water in the extent, and the coast around it.
struct MappedWater {
  std::vector<ground::LandCoverPolygon> sea{};    ///< In the extent.
  std::vector<ground::LandCoverPolygon> lakes{};  ///< All that reaches_beyond() the extent, with their levels.
  CoastSides coast{{}};                           ///< Also beyond the extent.
  bool has_sea() const { return !sea.empty() || !coast.is_empty(); }
};

/// True if a standing water with a level lies on at least 1 km of the extent's border. Narrower ones end soon, as lakes
/// do; this one may reach to the horizon. O(border · vertices).
bool reaches_beyond(const ground::LandCoverPolygon& water, const Box2& extent);

/// Sets the covers of vertices in the extent, and of those outside with known heights; sea has height 0, a lake its
/// level in whole metres.
///
/// - In the extent, polygons decide.
/// - Outside, the side of a coastline within 1 km decides; else heights up to 0 are sea, as heightmaps of 1 to 3 arc
///   seconds are 0 at sea. Polders are then sea. Without sea and coast there is none.
/// - A lake goes on from vertex to vertex, as long as known heights are within 1 m of its level.
/// @param known   One value for each vertex.
/// @param around  Heights are set; covers are set by this.
void find_open_water(const MappedWater& water, const Box2& extent, const std::vector<bool>& known,
                     Surroundings& around);

/// Returns the cover of a place whose height is unknown, by the side of the nearest coastline; nothing without coast.
std::optional<Cover> cover_by_coast(const MappedWater& water, Vec2 place);

}  // namespace citykiln::surroundings
