// Shells: walls without a roof, for ruins and for buildings under construction.
#pragma once

#include "compiler/map/features.h"

namespace citykiln::map {

/// The thickness of a shell's walls, in metres.
inline constexpr double kShellWall_m = 0.5;

/// Returns a polygon of the walls along the outer ring of a footprint, open inside. A polygon that has holes, or is too
/// narrow for two walls and a room of 2 m² between them, is returned unchanged.
Polygon shell_walls(const Polygon& polygon);

/// Makes a footprint a shell: without a roof, without windows, of bare material unless one is tagged.
/// @param is_ruin  True for a ruin: one storey high unless a height is tagged.
void make_shell(bool is_ruin, bool is_height_tagged, Footprint& footprint);

}  // namespace citykiln::map
