// Box junctions: yellow crossed lines on junctions with signals where main roads of Britain and Ireland meet.
#pragma once

#include <span>

#include "compiler/scene/land_cover.h"

namespace citykiln::scene {

/// The width of the panel of a box junction, and the distance of its lines across the panel, in metres. Junctions that
/// are wider than that across their first arm have none. TSRGD 2016, diagram 1043: lines of 0.1 to 0.15 m.
inline constexpr double kBoxPanel_m = 24, kBoxLines_m = 2.4;

/// Adds a piece with these markings to the polygon of each such junction: three or more of its arms are primary,
/// secondary or tertiary roads, and one arm of any class has signals within 20 m of the junction.
/// O(junctions + box junctions · polygons).
/// @param first_run  The first unused number of a run.
void add_box_junctions(std::span<const roads::Road> roads, std::span<const roads::Junction> junctions,
                       std::uint32_t first_run, LandCover& cover);

}  // namespace citykiln::scene
