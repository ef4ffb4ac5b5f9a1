// Checks the USD outputs of a run by reading them with other code than wrote them (exporters/usd/read_layer.h).
#pragma once

#include <span>

#include "compiler/contract/result.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_tile.h"

namespace citykiln::verify {

/// Compares the level layers of one tile with what its .glb has, where the run wrote one that is not packed, else with
/// what baking the manifest gives: the meshes of each layer by vertices, triangles and bounds, instances, ids, origin,
/// tolerance and errors. Tests that each layer holds together: indices in range, one value for each vertex or face,
/// extents that are the points' bounds, prototypes, materials and textures that are there, attribution.
/// @param levels  The files of the tile, sorted by level; not empty.
/// Errors: a layer that cannot be read; a tile that the manifest does not contain. Memory: one level.
Result<CheckResults> check_usd_tile(const LoadedRun& loaded, std::span<const WrittenTile> levels);

/// Tests the layers of scene and tiles: a payload for each tile and level, placed at the tile's origin, with bounds,
/// tolerance, errors and attribution; the finest level is the default. Error: a layer that cannot be read.
Result<CheckResults> check_usd_scene(const LoadedRun& loaded);

}  // namespace citykiln::verify
