// Terrain: a fractal, eroded by water, with rivers, lakes and a coast.
#pragma once

#include <cstdint>

#include "compiler/invent/land/terrain_settings.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// Returns the terrain about a map, with its water indexed.
///
/// @param map_side_m  The side of the mapped square, metres. The square's middle is the origin; the terrain reaches
///                    beyond it on all sides.
///
/// Guarantees: every lattice point inside the border has a lower neighbour, except in lakes; rivers run from point to
/// point of equal or lower ground, and each ends in another river, a lake, the sea or on the border. Every CPU gives
/// the same bytes. Cost: about 0.15 s a step of erosion and million points.
Terrain make_terrain(const TerrainSettings& settings, double map_side_m, std::uint64_t seed);

}  // namespace citykiln::invent
