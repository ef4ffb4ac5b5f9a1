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

/// True if a map has no element that a stage builds.
bool is_empty(const map::Features& features);

/// Returns the box to compile: spec.map.bbox, the map's own box, or that of its elements.
/// Error: the box is so large and empty that a typing error is likely (map::check_worth_baking()).
Result<source::LonLatBox> choose_worthwhile_extent(const CompileSpec& spec, const source::OsmData& osm, Report& report);

/// Returns the heights of the region. Error: heightmaps are given, but none covers any part of the region.
Result<map::Heightfield> read_heights(const CompileSpec& spec, const map::Plane& plane, const Box2& extent,
                                      Report& report);

/// Returns areas and watercourses without heights.
ground::Waters plan_dry_waters(const map::FeatureView& features, Report& report);

/// Returns areas and watercourses, with levels of water and profiles of watercourses.
ground::Waters plan_waters(const map::FeatureView& features, const map::Heightfield& heights, Report& report);

/// The recipes that cover the ground of the whole map, without buildings. Refers to the products of stages.
struct WholeGround {
  const map::Heightfield& heights;
  std::span<const ground::LandCoverPolygon> surfaces{};
  std::span<const roads::Road> roads{};
  std::span<const roads::Junction> junctions{};
  std::span<const roads::Strip> streams{};
  std::span<const ground::Landform> landforms{};
};

/// The graded terrain of the whole map, without the rounded street corners, which are made only when baking.
ground::GradedTerrain grade_whole_map(const WholeGround& ground, const structures::Structures& spans,
                                      const Box2& extent);

/// The land cover of the whole map, in which piers look for free ground. It includes the footprints of building parts.
std::vector<ground::LandCoverPolygon> pier_obstacles(const WholeGround& ground,
                                                     std::span<const map::Footprint> footprints);

/// The land cover of the whole map in which things look for free places: with the buildings that stand on the ground.
std::vector<ground::LandCoverPolygon> thing_obstacles(const WholeGround& ground,
                                                      std::span<const buildings::Building> buildings);

}  // namespace citykiln
