// Joins heightmap files that are cut from one grid.
#pragma once

#include <vector>

#include "compiler/source/raster.h"

namespace citykiln::source {

/// Joins consecutive rasters whose samples lie on one grid (same reference system and steps, offset by whole samples),
/// so that voids and spikes at the seam are mended from both sides. Must run before spikes_to_voids() and fill_voids().
///
/// In overlaps the first raster with a sample wins. Rasters are joined only if they fill a rectangle, so that joining
/// never creates voids: four one-degree tiles become one raster, three become two.
///
/// Guarantees: cutting a raster along a column or row and joining the parts, in either order, restores its samples, and
/// exactly its georeference if the part with the first sample keeps its origin. The result has the name and credit of
/// the first part. Rasters of different grids keep their order. Cannot fail. O(samples).
std::vector<Raster> join_rasters(std::vector<Raster> rasters);

}  // namespace citykiln::source
