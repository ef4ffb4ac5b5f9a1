#include "compiler/whole_map.h"

#include <utility>

#include "compiler/ground/grading/graded_box.h"
#include "compiler/ground/plan.h"
#include "compiler/map/extent/choose_extent.h"
#include "compiler/map/heights/fit_heightmaps.h"
#include "compiler/map/heights/resample.h"
#include "compiler/map/plane/lonlat_box.h"
#include "compiler/scene/land_cover.h"
#include "compiler/source/read_raster.h"

namespace citykiln {
namespace {

scene::CoverRecipes cover_of(const WholeGround& ground) {
  return {.areas = ground.surfaces,
          .roads = ground.roads,
          .junctions = ground.junctions,
          .watercourses = ground.streams,
          .landforms = ground.landforms,
          .footprints = {}};
}

}  // namespace

bool is_empty(const map::Features& features) {
  return features.tracks.empty() && features.footprints.empty() && features.areas.empty() &&
         features.sports_areas.empty() && features.waterways.empty() && features.barriers.empty() &&
         features.landforms.empty() && features.points.empty() && features.things.empty() &&
         features.tree_rows.empty() && features.power_lines.empty();
}

Result<source::LonLatBox> choose_worthwhile_extent(const CompileSpec& spec, const source::OsmData& osm,
                                                   Report& report) {
  Result<source::LonLatBox> box = map::choose_extent(osm, spec.map.bbox, report);
  if (!box && spec.clip) return Error{spec.clip->where, box.error().message};
  if (!box) return box;
  const map::Plane plane(spec.map.origin.value_or(map::default_origin(*box)));
  const bool has_box = spec.map.bbox || osm.header_box;
  const Result<Done> worthwhile = map::check_worth_baking(map::extent_of(plane, *box), osm, has_box);
  if (!worthwhile) return worthwhile.error();
  return box;
}

Result<map::Heightfield> read_heights(const CompileSpec& spec, const map::Plane& plane, const Box2& extent,
                                      Report& report) {
  if (spec.rasters.empty()) report.add(Code::kNoHeightmap, {});
  const source::LonLatBox window = map::lonlat_box_of(extent, plane);
  Result<std::vector<source::Raster>> rasters = source::read_heightmaps(spec.rasters, &window, report);
  if (!rasters) return rasters.error();
  rasters = map::fit_heightmaps(std::move(*rasters), plane, extent, report);
  if (!rasters) return rasters.error();
  return map::resample(*rasters, plane, extent, report);
}

ground::Waters plan_dry_waters(const map::FeatureView& features, Report& report) {
  std::vector<ground::LandCoverPolygon> surfaces = ground::plan(features, report);
  return {std::move(surfaces), ground::plan_streams(features, report)};
}

ground::Waters plan_waters(const map::FeatureView& features, const map::Heightfield& heights, Report& report) {
  ground::Waters dry = plan_dry_waters(features, report);
  return ground::plan_water_heights(std::move(dry.surfaces), std::move(dry.streams),
                                    ground::covered_waterways(features), heights, report);
}

ground::GradedTerrain grade_whole_map(const WholeGround& ground, const structures::Structures& spans,
                                      const Box2& extent) {
  // slopes start at the outlines of junctions, as in tiles, so those of roads are needed too
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(cover_of(ground));
  return ground::grade_terrain<structures::Span>(ground.heights,
                                                 {.roads = ground.roads,
                                                  .streams = ground.streams,
                                                  .surfaces = surfaces,
                                                  .box = ground::graded_box(extent, ground.heights),
                                                  .has_kerbs = false,
                                                  .landforms = ground.landforms},
                                                 spans.bridges, spans.tunnels);
}

std::vector<ground::LandCoverPolygon> pier_obstacles(const WholeGround& ground,
                                                     std::span<const map::Footprint> footprints) {
  scene::CoverRecipes cover = cover_of(ground);
  for (const map::Footprint& footprint : footprints)
    cover.footprints.push_back(scene::footprint_surface(footprint.id, footprint.polygon));
  return scene::coarse_land_cover(cover);
}

std::vector<ground::LandCoverPolygon> thing_obstacles(const WholeGround& ground,
                                                      std::span<const buildings::Building> buildings) {
  scene::CoverRecipes cover = cover_of(ground);
  for (const buildings::Building& building : buildings)
    if (building.stands_on_ground) cover.footprints.push_back(scene::footprint_surface(building));
  return scene::coarse_land_cover(cover);
}

}  // namespace citykiln
