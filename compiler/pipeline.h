// compile() turns a map into a scene and bake_scene() bakes its tiles. pipeline.cpp calls the rooms in order: read it
// first.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "compiler/bake/bake.h"
#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/map/layer_tags.h"
#include "compiler/map/places.h"
#include "compiler/scene/scene.h"
#include "compiler/source/osm_data.h"
#include "compiler/source/owns_place.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"

namespace citykiln {

struct CompileResult {
  scene::Scene scene;
  Report report;
  ground::ProfileMeasures profiles;  ///< Height consistency of the planned lines.
  std::vector<StageCost> costs;
  map::Places places;         ///< Of the elements that the report's diagnoses name.
  map::LayerTags layer_tags;  ///< Of the ways that diagnoses of two objects name.
};

/// Compiles a map and heightmaps to a scene of recipes, with the ledger and diagnoses of all stages.
///
/// Guarantees: the same inputs and spec give the same scene, whatever the number of threads and the order of elements
/// in the file; a tile compiled alone (spec.only) equals that tile of the whole. Errors: an input that cannot be read;
/// a map with nothing to compile; heightmaps that do not cover any of the map; tiles outside the map. Cost: linear,
/// except for sorting the extract; memory for the whole extract.
Result<CompileResult> compile(const CompileSpec& spec, const OnProgress& on_progress);

/// What a region cannot know from its own data (regions/radii.h). Each is that of the whole extent.
struct Survey {
  source::LonLatBox extent;                      ///< In degrees.
  scene::Header header;                          ///< Without rules and species.
  map::Heightfield heights;                      ///< Of the extent, or around a region.
  std::vector<ground::LandCoverPolygon> waters;  ///< Areas of water with their levels.
  std::vector<roads::Strip> streams;             ///< With their profiles.
  map::Places places{};                          ///< Of the elements that the report's diagnoses name.
};

/// Finds what holds for the whole extent, from the waters and coasts of a map and its heightmaps.
/// @param extract  The waters and coasts of spec.map_path; any other element changes nothing.
/// Diagnoses heightmaps and the heights of waters only. Errors: those of compile(). Memory: the heights of the extent,
/// and its waters.
Result<Survey> survey(const CompileSpec& spec, const std::string& extract, const source::LonLatBox& extent,
                      Report& report, const OnProgress& on_progress);

/// Compiles the tiles of spec.only from a part of a map.
/// @param extract  All that lies within regions::kRegionHalo_m of these tiles.
/// @param survey   Of the whole extent; heights, waters and streams around these tiles will do.
/// @param owns     The places whose elements are counted and diagnosed (source/owned_elements.h).
///
/// Guarantees: the chunks are those of compile(); the header too, except rules and species, which are those of these
/// tiles. Memory: for this part.
Result<CompileResult> compile_region(const CompileSpec& spec, const std::string& extract, const Survey& survey,
                                     const source::OwnsPlace& owns, const OnProgress& on_progress);

/// Receives one tile at one level. An error ends baking.
using OnBakedTile = std::function<Result<Done>(const bake::BakedTile& tile, std::size_t level)>;

/// Indices of a chunk in Scene::chunks and of a level in the tolerances.
struct ChunkLevel {
  std::size_t chunk, level;
};
/// Processes a baked tile in parallel with others; must write to a place of its own only.
using ProcessTile = std::function<void(ChunkLevel at, bake::BakedTile&& tile)>;
/// Receives the processed tile, and what was diagnosed while it was baked. An error ends baking.
using CollectTile = std::function<Result<Done>(ChunkLevel at, const Report& diagnosed)>;
/// Whether a tile exists already and is not baked.
using ExistsTile = std::function<bool(ChunkLevel at)>;

/// Bakes every chunk at every tolerance and passes the tiles to `take`, one at a time, ordered by tile, then level.
/// Adds dropped objects to `report`. Memory: kInFlightPerThread levels for each thread, their tiles' ground, and the
/// ground of one more tile.
/// @param ladder_m  Tolerances, increasing, > 0.
/// @param most_instances  As for bake::prepare().
Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> ladder_m, int threads, Report& report,
                        const OnProgress& on_progress, const OnBakedTile& take,
                        std::size_t most_instances = bake::kAnyInstances);

/// What to do with tiles in parallel baking.
struct TileHandlers {
  ExistsTile exists;    ///< Called before baking; gives the same answer each time.
  ProcessTile process;  ///< Called as soon as a tile is baked; not for tiles that exist.
  CollectTile take;     ///< Called for all tiles in order, one at a time.
};

/// Like the above, with parallel processing. A tile is prepared for all levels of the ladder if one of them is baked,
/// so that a level never depends on which others exist.
Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> ladder_m, int threads, Report& report,
                        const OnProgress& on_progress, const TileHandlers& handlers,
                        std::size_t most_instances = bake::kAnyInstances);

}  // namespace citykiln
