// Joins the halves of a map that lies on both sides of the meridian of 180°.
#pragma once

#include <vector>

#include "compiler/source/order_elements.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Adds 360° to the longitudes below 0 of a map across 180°, so that its western hemisphere lies east of its eastern
/// one. Other maps stay as they are. A map is across 180° if its nodes span more than 180° before, and less than
/// kWidestAcross_deg after that. The header's box is moved too, and removed if it is kWidestAcross_deg wide or wider
/// then. O(n).
void join_across_180(OsmData& data);

/// True if the map of these elements, with located ways, is across 180°. O(n).
bool is_across_180(const Elements& elements);

/// Moves all places by half a turn of the Earth, so that lines across 180° are short, or back. O(n).
void turn_half(Elements& elements);
void turn_half(std::vector<Location>& places);

/// The largest width of a map across 180°. A Location holds longitudes up to 214.7°: 1e-7 degrees in 32 bits.
inline constexpr double kWidestAcross_deg = 20;

}  // namespace citykiln::source
