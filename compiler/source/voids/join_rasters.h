// Joins heightmaps that were cut from one grid into several files.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/source/raster.h"

namespace citykiln::source {

/// Joins consecutive rasters whose samples lie on one grid (equal reference systems and steps, offset by whole
/// samples), so that voids and spikes at a seam are mended with the samples of both sides. Call it before
/// spikes_to_voids() and fill_voids().
///
/// Where rasters overlap, the first one with a height is used. Rasters are joined only if they fill a rectangle, so
/// joining never creates voids: four tiles of one degree in a square become one raster, three become two.
///
/// Guarantees: if a raster is cut along a column or row, joining its parts in either order restores its samples, and
/// exactly its georeference if the part with the first sample has the origin of the whole. The result has the name and
/// credit of the first part. Rasters with a step between them (step_of_m()), and those with RasterSpec::is_fitted, stay
/// separate. Rasters of different grids keep their order. Cannot fail. O(samples).
std::vector<Raster> join_rasters(std::vector<Raster> rasters);

/// Returns the step between two heightmaps with different datums: the mean of their differences where they meet. Empty
/// if there is no clear step. A step is clear if there are at least 8 differences, and their mean is, in either
/// direction, more than 2 m plus a tenth of `spacings_m`, and more than twice their standard deviation.
///
/// @param spacings_m  The sum of the spacings of samples of both.
std::optional<double> step_of_m(std::span<const double> differences_m, double spacings_m);

}  // namespace citykiln::source
