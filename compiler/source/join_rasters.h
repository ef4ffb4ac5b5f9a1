// Heightmaps cut out of one grid, put together again.
#pragma once

#include <vector>

#include "compiler/source/raster.h"

namespace citykiln::source {

/// Joins neighbours in the list whose samples lie on one grid (same system, same steps, apart by whole samples), so
/// that voids and spikes at the cut are mended from both sides, and heights there do not depend on the cut. Run it
/// before spikes_to_voids and fill_voids.
///
/// Where parts overlap, the first that has a sample gives it. A part joins only if the parts then fill a rectangle, so
/// that no void comes into being: four tiles of a degree become one raster, three of them two.
///
/// Guarantees: the samples of a raster cut in two along a column or row, in either order, are those of the whole, at
/// the same places to the bit where the part that begins it keeps its origin. The joined raster has the name and credit
/// of the first. Rasters of different grids keep their order. Total. O(samples).
std::vector<Raster> join_rasters(std::vector<Raster> rasters);

}  // namespace citykiln::source
