// Maps on both sides of the meridian of 180°.
#pragma once

#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Moves the western hemisphere of a map across 180° to the east of its eastern one: longitudes below 0 grow by 360°,
/// and a header's box across 180° has its eastern side there; a wider box is left out. A map is across 180° if that
/// makes it narrower than kWidestAcross_deg, and it is wider than 180° without. Other maps stay as they are. O(n).
void join_across_180(OsmData& data);

/// The largest width of a map across 180°; OSM's longitudes of 32 bits end at 214.7°.
inline constexpr double kWidestAcross_deg = 20;

}  // namespace citykiln::source
