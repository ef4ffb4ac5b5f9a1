// Steps of compile() and survey() that need the whole map: its extent, heights, waters and graded terrain.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/water/plan_water_heights.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/plane.h"
#include "compiler/scene/scene.h"
#include "compiler/source/osm_data.h"
#include "compiler/spec.h"
#include "compiler/structures/plan.h"

namespace citykiln {

/// True if a map has no feature that a stage makes recipes of.
bool is_empty(const map::Features& features);

/// Returns the box to compile, in degrees: spec.map.bbox, else the map's own box, else that of its elements.
/// Errors: a bbox that does not touch the map (map::choose_extent()); a box that is too large, or so large and empty
/// that a typing error is likely (map::check_worth_baking()).
Result<source::LonLatBox> choose_worthwhile_extent(const CompileSpec& spec, const source::OsmData& osm, Report& report);

/// Reads the heightmaps of spec.rasters, fits them, and returns the terrain of the extent and one step beyond
/// (map::resample()). Without heightmaps it is flat at 0, diagnosed kNoHeightmap.
/// Errors: those of source::read_heightmaps() (a file that cannot be read, heights that are not on Earth), of
/// map::fit_heightmaps() (offset=auto without a partner) and of map::resample() (no heightmap covers any part of the
/// extent, an unknown reference system).
Result<map::Heightfield> read_heights(const CompileSpec& spec, const map::Plane& plane, const Box2& extent,
                                      Report& report);

/// Returns the land cover areas and the watercourses of a map, without water levels and profiles.
ground::Waters plan_dry_waters(const map::FeatureView& features, Report& report);

/// Returns the result of plan_dry_waters() with the levels of standing water and the profiles of watercourses.
ground::Waters plan_waters(const map::FeatureView& features, const map::Heightfield& heights, Report& report);

/// The recipes that cover the ground of the whole map, without buildings. Refers to the products of stages, which must
/// outlive it.
struct WholeGround {
  const map::Heightfield& heights;
  std::span<const ground::LandCoverPolygon> surfaces{};
  std::span<const roads::Road> roads{};
  std::span<const roads::Junction> junctions{};
  std::span<const roads::Strip> streams{};
  std::span<const ground::Landform> landforms{};
};

/// Returns the graded terrain of the whole map, without kerbs and without the rounded street corners, which are made
/// only when a tile is baked. Slopes begin at the outlines of roads and junctions, as in tiles.
ground::GradedTerrain grade_whole_map(const WholeGround& ground, const structures::Structures& spans,
                                      const Box2& extent);

/// Returns the land cover of the whole map on which piers look for free ground: that of `ground` and all footprints,
/// also those of building parts.
std::vector<ground::LandCoverPolygon> pier_obstacles(const WholeGround& ground,
                                                     std::span<const map::Footprint> footprints);

/// Returns the land cover of the whole map in which things look for free places: that of `ground` and the footprints of
/// the buildings that stand on the ground.
std::vector<ground::LandCoverPolygon> thing_obstacles(const WholeGround& ground,
                                                      std::span<const buildings::Building> buildings);

}  // namespace citykiln
