// Writes the tile tree of a scene as 3D Tiles.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "compiler/verify/run_report.h"
#include "exporters/output_folder.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::commands {

/// Bakes a scene and writes 3dtiles/tileset.json with its contents.
///
/// - A tile's levels are a chain, coarse to fine. A level that states no larger error than the finer one before it is
///   left out.
/// - Above the tiles is a quadtree over the region. The tolerance of an inner tile is twice its children's. Up to a
///   tolerance of 4/3 kCoarsest_m it is joined from tiles that are baked at 3/4 of it; above, from its children without
///   what is near the terrain. The other quarter decimates its terrain (bake/simplify_tile.h), unless the
///   tile is wide and its tolerance small, as above levels of 2.5 m.
/// - error_m of each tile is that of its content, and more than its children's.
///
/// - With Outputs::surroundings the root has no content and two children: the tree and the land around it.
///
/// Adds to `report` what levels drop, unless .glb files are written too, which add the same; and kNoGeoidHeight.
/// Memory: bake_scene()'s, and the coarse levels of tiles and nodes whose parents are not complete yet.
Result<std::vector<verify::WrittenFile>> write_tiles3d(const scene::Scene& scene, const Outputs& outputs, int threads,
                                                       exporters::OutputFolder& folder, Report& report,
                                                       const OnProgress& on_progress);

/// What holds for the tileset of a scene. Error: a geoid that cannot be read.
Result<exporters::TilesetFacts> tileset_facts(const scene::Header& header, const Outputs& outputs);

}  // namespace citykiln::commands
