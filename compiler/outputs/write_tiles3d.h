// Writes the tile tree of a scene as 3D Tiles.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/outputs/run_report.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "exporters/output_folder.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::outputs {

/// Returns the geoid over the extent of a scene. Error: a geoid that cannot be read.
Result<map::Geoid> geoid_of(const scene::Header& header, const Outputs& outputs);

/// Bakes a scene and writes tileset.json with its contents, into 3dtiles/ (Outputs::tiles3d), into the archive
/// tileset.3tz (Outputs::tiles3d_archive), or both. An inner tile is a tile of the tree above the tiles of the scene.
///
/// - The tree is that of plan_tree() (tiles3d/plan_tree.h), with its bounds of errors and boxes: the tileset is known
///   before anything is baked, so that a server sends the same tree at once.
/// - The levels of a tile are a chain from coarse to fine.
/// - Above the tiles is a quadtree over the extent. The tolerance of an inner tile is twice the tolerance of its
///   children. Up to 4/3 kCoarsest_m an inner tile is joined from tiles that are baked at 3/4 of its tolerance. Above
///   that it is joined from its children, without objects near the terrain. The other quarter of the tolerance is spent
///   on decimating the terrain (bake/tiles/simplify_tile.h), of each part that is baked for itself, unless the tile is
///   very wide for its tolerance, as above levels of 2.5 m.
/// - Outputs::lights are lights of all levels of a tile.
/// - Unless Outputs::surroundings is kNo, where the header has land around, the root has no content and two children:
///   the tree and that land.
///
/// Returns the files that were written; none if the scene has no chunk. Errors: a file that cannot be written; those of
/// joining tiles (bake/tiles/join_tiles.h).
///
/// Adds to `report` kNoGeoidHeight, if no geoid is given and the world is no cylinder; and what baking reports, unless
/// .glb or USD files are written too, whose tiles are counted instead.
/// @param geoid  The result of geoid_of(), here and below.
/// @param textures  The textures that contents show.
/// Memory: bake_scene(), and the coarse levels of tiles and nodes whose parents are not complete yet.
Result<std::vector<WrittenFile>> write_tiles3d(const scene::Scene& scene, const Outputs& outputs,
                                               const map::Geoid& geoid, const TextureChoice& textures, int threads,
                                               exporters::OutputFolder& folder, Report& report,
                                               const OnProgress& on_progress);

/// Returns the properties of the tileset of a scene.
exporters::TilesetFacts tileset_facts(const scene::Header& header, const Outputs& outputs, const map::Geoid& geoid);

}  // namespace citykiln::outputs
