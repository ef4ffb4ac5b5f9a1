// Shells: buildings of which only walls stand, without a roof: ruins, and buildings under construction.
#pragma once

#include "compiler/map/features.h"

namespace citykiln::map {

/// The thickness of a shell's walls, in metres.
inline constexpr double kShellWall_m = 0.5;

/// Returns the area of the walls along the outer ring of a footprint; the room inside is a hole. A polygon is returned
/// unchanged if it has holes, or if it leaves no single room of at least 2 m² between the walls.
Polygon shell_walls(const Polygon& polygon);

/// Changes a footprint's tags into those of a shell: with a flat roof, without windows, of stone (ruin) or concrete
/// unless a wall material is tagged. Its polygon stays unchanged (shell_walls()).
/// @param is_ruin           True for a ruin, false for a building under construction.
/// @param is_height_tagged  True if the height is tagged; else a ruin becomes one storey (3 m) high.
void make_shell(bool is_ruin, bool is_height_tagged, Footprint& footprint);

}  // namespace citykiln::map
