// Encodes the heights of a terrain as a GeoTIFF.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/invent/terrain.h"
#include "compiler/invent/write/world_place.h"

namespace citykiln::invent {

/// Returns a GeoTIFF of 32-bit floats without compression, rows from the north. Its reference system is the transverse
/// Mercator projection about the world's middle, so that samples lie on whole steps of the plane; samples are points.
/// Source: "TIFF 6.0" (1992); "OGC GeoTIFF Standard" 1.1 (2019).
std::vector<std::byte> encode_heights(const Terrain& terrain, const WorldPlace& place);

}  // namespace citykiln::invent
