// Checks the USD outputs of a run with a reader that is independent of their writer (exporters/usd/read_layer.h).
#pragma once

#include <span>

#include "compiler/contract/result.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_tile.h"

namespace citykiln::verify {

/// Checks the layers of one tile, one per level. Each must equal the tile's .glb, if the run wrote one without
/// compression and for a target that keeps normals, else the tile that baking the manifest gives: the meshes of each
/// layer by points and triangles, in order; instances by prototypes, places, orientations (within half precision),
/// scales and features; ids, names, assumptions, origin, tolerance and errors. The tile's layer must be at that origin.
/// Normals, colours and texture coordinates are not compared. Each layer must also be consistent: indices in range, one
/// value per vertex or face, extents that are the bounds of the points, prototypes, materials and textures that exist,
/// attribution.
/// @param levels  The files of the tile, sorted by level; not empty.
/// Errors: a layer that cannot be read; a tile that the manifest does not contain. Memory: one level.
Result<CheckResults> check_usd_tile(const LoadedRun& loaded, std::span<const outputs::WrittenTile> levels);

/// Tests the layers of the scene and of the tiles: one payload per tile and level, with tolerance, error_m and
/// attribution; the scene places a tile where its layer does, and states bounds, which are not compared; the finest
/// level is the default. Error: a layer that cannot be read.
Result<CheckResults> check_usd_scene(const LoadedRun& loaded);

}  // namespace citykiln::verify
