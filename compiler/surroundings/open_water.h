// Decides where the sea and wide lakes continue around the extent.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/surroundings/coast_sides.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::surroundings {

/// The sea and wide lakes in the extent, and the coastlines in and around it.
struct MappedWater {
  std::vector<ground::LandCoverPolygon> sea{};    ///< In the extent.
  std::vector<ground::LandCoverPolygon> lakes{};  ///< Lakes that reaches_beyond(); all have levels.
  CoastSides coast{{}};                           ///< Also beyond the extent.
  bool has_sea() const { return !sea.empty() || !coast.is_empty(); }
};

/// True if a water area with a level touches the extent's border from inside along at least 1 km in
/// all, tested every 32 m. Narrower areas end soon; wider ones may reach to the horizon.
/// O(border · vertices).
bool reaches_beyond(const ground::LandCoverPolygon& water, const Box2& extent);

/// Sets the cover of all vertices of `around` to sea, lake or land, and the heights of water: 0 for
/// the sea, its level in whole metres for a lake.
///
/// - Polygons decide in the extent.
/// - Only vertices with known heights may be water outside of it. The side of a coastline that is
///   mapped within 1 km decides. Heights up to 0 are sea elsewhere, since heightmaps of 1 to 3 arc
///   seconds are 0 at sea; polders become sea, too. There is no sea without a sea polygon or a
///   coastline.
/// - A lake goes on from its vertices in the extent to neighbours on land outside, where the known
///   height is within 1 m of its level.
///
/// O(vertices · coastline and polygons).
/// @param known   For each vertex, true if its height is known.
/// @param around  The grid, with heights; its covers are replaced.
void find_open_water(const MappedWater& water, const Box2& extent, const std::vector<bool>& known,
                     Surroundings& around);

/// Returns the cover of a place whose height is unknown, by the side of the nearest coastline at
/// any distance; nothing if there are no coastlines.
std::optional<Cover> cover_by_coast(const MappedWater& water, Vec2 place);

}  // namespace citykiln::surroundings
