// Box junctions: yellow crossed lines on junctions with signals where main roads of Britain and Ireland meet.
#pragma once

#include <span>

#include "compiler/scene/land_cover.h"

namespace citykiln::scene {

/// The width of the panel that all box junctions of a tile show, and the distance of its lines, in metres. Wider
/// junctions have none. TSRGD 2016, diagram 1043: lines of 0.1 to 0.15 m.
inline constexpr double kBoxPanel_m = 24, kBoxLines_m = 2.4;

/// Gives the polygons of such junctions a piece each: junctions of three or more arms of primary, secondary or tertiary
/// roads, with signals on one of them within 20 m of the junction. O(junctions · log polygons).
/// @param first_run  The first unused number of a run.
void add_box_junctions(std::span<const roads::Road> roads, std::span<const roads::Junction> junctions,
                       std::uint32_t first_run, LandCover& cover);

}  // namespace citykiln::scene
