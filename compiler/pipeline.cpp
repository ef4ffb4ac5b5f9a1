#include "compiler/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "compiler/bake/bake.h"
#include "compiler/buildings/plan.h"
#include "compiler/contract/for_each_slot.h"
#include "compiler/contract/give_back_memory.h"
#include "compiler/contract/once.h"
#include "compiler/ground/grading/graded_box.h"
#include "compiler/ground/plan.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/water/plan_water_heights.h"
#include "compiler/map/choose_extent.h"
#include "compiler/map/locate.h"
#include "compiler/map/lonlat_box.h"
#include "compiler/map/resample.h"
#include "compiler/plants/plan.h"
#include "compiler/props/plan.h"
#include "compiler/roads/fit_assumed_widths.h"
#include "compiler/roads/plan.h"
#include "compiler/roads/width_limits/limit_widths.h"
#include "compiler/scene/assemble.h"
#include "compiler/scene/land_cover.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/plan.h"
#include "compiler/source/read_osm.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/read_texts.h"
#include "compiler/structures/plan.h"
#include "compiler/structures/plan_parapet_gaps.h"
#include "compiler/structures/plan_piers.h"
#include "compiler/structures/within_extent.h"
#include "compiler/surroundings/grid_lines.h"
#include "compiler/surroundings/plan.h"

namespace citykiln {
namespace {

/// Compiles a whole map, or, with a survey, the tiles of spec.only from an extract of what lies around them.
Result<CompileResult> compile_part(const CompileSpec& spec, const std::string& extract, const Survey* survey,
                                   const source::OwnsPlace& owns, const OnProgress& on_progress);

bool is_empty(const map::Features& features);
Result<source::LonLatBox> choose_worthwhile_extent(const CompileSpec& spec, const source::OsmData& osm, Report& report);
Result<map::Heightfield> read_heights(const CompileSpec& spec, const map::Plane& plane, const Box2& region,
                                      Report& report);

/// Areas and watercourses without heights.
ground::Waters plan_dry_waters(const map::Features& features, Report& report);
ground::Waters plan_waters(ground::Waters dry, const map::Features& features, const map::Heightfield& heights,
                           Report& report);
/// The same areas and watercourses, with what the survey says of those that it knows.
ground::Waters surveyed_waters(ground::Waters waters, const Survey& survey);

/// The properties of the whole scene, without rules and species.
Result<scene::Header> make_header(const CompileSpec& spec, const map::Plane& plane, const Box2& region,
                                  const scene::Recipes& recipes);

/// The land around the region as far as the heightmaps know it.
Result<surroundings::Surroundings> plan_surroundings(const CompileSpec& spec, const map::Plane& plane,
                                                     const scene::Recipes& recipes, const Box2& region);

/// The rule files that the styles of the buildings need. A file in the spec's folder replaces the shipped file of its
/// name.
Result<std::vector<buildings::RuleText>> rules_for(const CompileSpec& spec,
                                                   const std::vector<buildings::Building>& buildings);

/// The graded terrain of the whole map, without the rounded street corners that only baking knows.
ground::GradedTerrain grade_whole_map(const scene::Recipes& recipes, const Box2& region);

/// The land cover of the whole map, where piers look for free ground. All footprints count, those of parts too.
std::vector<ground::LandCoverPolygon> pier_obstacles(const scene::Recipes& recipes, const map::Features& features);

}  // namespace

Result<CompileResult> compile(const CompileSpec& spec, const OnProgress& on_progress) {
  return compile_part(spec, spec.map_path, nullptr, {}, on_progress);
}

Result<CompileResult> compile_region(const CompileSpec& spec, const std::string& extract, const Survey& survey,
                                     const source::OwnsPlace& owns, const OnProgress& on_progress) {
  return compile_part(spec, extract, &survey, owns, on_progress);
}

namespace {

Result<CompileResult> compile_part(const CompileSpec& spec, const std::string& extract, const Survey* survey,
                                   const source::OwnsPlace& owns, const OnProgress& on_progress) {
  assert(!spec.map_path.empty() && spec.tile_m > 0 && std::ranges::is_sorted(spec.only));
  StageTimer timer(on_progress);
  Report report;
  scene::Recipes recipes;

  // read the map, project it to the plane and classify its elements
  timer.enter("read map");
  const Result<source::OsmData> osm = source::read_osm(extract, spec.threads, report, owns);
  if (!osm) return osm.error();
  timer.enter("project and classify");
  const Result<source::LonLatBox> box = survey ? survey->extent : choose_worthwhile_extent(spec, *osm, report);
  if (!box) return box.error();
  const map::Plane plane(survey ? survey->header.origin : spec.map.origin.value_or(map::default_origin(*box)));
  map::Features features = map::locate(*osm, plane, *box, spec.map, report);
  if (!survey && is_empty(features)) return Error{spec.map_path, "contains nothing to compile in this area"};

  // resample the heightmaps
  timer.enter("terrain heights");
  Result<map::Heightfield> heights = survey ? survey->heights : read_heights(spec, plane, features.region, report);
  if (!heights) return heights.error();
  recipes.heights = std::move(*heights);

  // plan roads, land cover and their heights
  timer.enter("roads");
  features.tracks = roads::fit_assumed_widths(features);
  recipes.roads = roads::plan(features, report);
  recipes.junctions = roads::plan_junctions(recipes.roads, report);
  recipes.roads = roads::limit_widths(std::move(recipes.roads), recipes.junctions, features.footprints,
                                      roads::ways_through_buildings(features), report);
  timer.enter("land cover and water");
  ground::Waters waters = survey ? surveyed_waters(plan_dry_waters(features, report), *survey)
                                 : plan_waters(plan_dry_waters(features, report), features, recipes.heights, report);
  recipes.surfaces = std::move(waters.surfaces), recipes.watercourses = std::move(waters.streams);
  timer.enter("road heights");
  ground::Profiles profiles = ground::plan_profiles(features, std::move(recipes.roads), recipes.junctions,
                                                    recipes.watercourses, recipes.surfaces, recipes.heights, report);
  const ground::ProfileMeasures measured = ground::measure_profiles(features, profiles);
  recipes.roads = std::move(profiles.roads);

  // plan bridges and tunnels, then the objects that stand on the ground
  timer.enter("bridges and tunnels");
  recipes.structures = structures::plan(features, profiles.off_ground, recipes.heights, report);
  recipes.structures.bridges = structures::find_parapet_gaps(std::move(recipes.structures.bridges));
  const ground::GradedTerrain graded = grade_whole_map(recipes, features.region);
  recipes.structures.bridges =
      structures::place_piers(std::move(recipes.structures.bridges), graded, pier_obstacles(recipes, features), report);
  recipes.structures = structures::within_extent(std::move(recipes.structures), features.region, report);
  timer.enter("buildings");
  recipes.buildings = buildings::plan(features, graded, report);
  timer.enter("plants");
  recipes.plants = plants::plan(features, recipes.surfaces, recipes.roads, recipes.heights, report);
  timer.enter("props");
  recipes.props = props::plan(features, report);

  // plan the land around the extent, describe the sky and the sources
  timer.enter("surroundings");
  Result<scene::Header> header = survey ? survey->header : make_header(spec, plane, features.region, recipes);
  if (!header) return header.error();

  // sort all recipes into tiles
  timer.enter("sort into tiles");
  recipes.texts = features.texts;
  Result<std::vector<buildings::RuleText>> rules = rules_for(spec, recipes.buildings);
  if (!rules) return rules.error();
  header->rules = std::move(*rules);
  header->species = plants::species_texts_for(recipes.plants, has_hedges(recipes.props));
  scene::Scene scene = scene::assemble(recipes, *header, spec.only, spec.threads);
  map::Places places = map::places_of(*osm, report);
  map::LayerTags layer_tags = map::layer_tags_of(*osm, report);
  // all that is baked is the region's own
  report.lift_limit();
  return CompileResult{std::move(scene), std::move(report), measured,
                       timer.finish(),   std::move(places), std::move(layer_tags)};
}

/// The waters of an extract in the plane, and where its elements lie.
struct LocatedWaters {
  map::Features features;
  map::Places places;
};

/// Reads and locates; the extract itself is gone when this returns. Its diagnoses are those of the regions.
Result<LocatedWaters> locate_waters(const CompileSpec& spec, const std::string& extract, const map::Plane& plane,
                                    const source::LonLatBox& extent) {
  Report repeated;
  const Result<source::OsmData> osm = source::read_osm(extract, spec.threads, repeated);
  if (!osm) return osm.error();
  give_back_memory();
  return LocatedWaters{map::locate(*osm, plane, extent, spec.map, repeated), map::places_of_ways_and_areas(*osm)};
}

/// The waters of an extract without heights, and where its elements lie.
struct DryWaters {
  Box2 region;
  ground::Waters waters;
  std::vector<Polyline> covered;  ///< Waterways in culverts and on aqueducts.
  map::Places places;
};

/// Each stage gives its memory back before the next: together they hold several times what this returns.
Result<DryWaters> read_dry_waters(const CompileSpec& spec, const std::string& extract, const map::Plane& plane,
                                  const source::LonLatBox& extent) {
  Result<LocatedWaters> located = locate_waters(spec, extract, plane, extent);
  if (!located) return located.error();
  give_back_memory();
  Report repeated;
  const map::Features& features = located->features;
  return DryWaters{features.region, plan_dry_waters(features, repeated), ground::covered_waterways(features),
                   std::move(located->places)};
}

/// Only the places of what is diagnosed.
map::Places of_diagnosed(map::Places places, const Report& report) {
  std::set<OsmId> named;
  for (const Diagnosis& diagnosis : report.diagnoses()) named.insert(diagnosis.object);
  std::erase_if(places, [&](const auto& place) { return !named.contains(place.first); });
  return places;
}

}  // namespace

Result<Survey> survey(const CompileSpec& spec, const std::string& extract, const source::LonLatBox& extent,
                      Report& report, const OnProgress& on_progress) {
  StageTimer timer(on_progress);
  timer.enter("survey");
  const map::Plane plane(spec.map.origin.value_or(map::default_origin(extent)));
  Result<DryWaters> dry = read_dry_waters(spec, extract, plane, extent);
  if (!dry) return dry.error();
  give_back_memory();
  scene::Recipes recipes;
  Result<map::Heightfield> heights = read_heights(spec, plane, dry->region, report);
  if (!heights) return heights.error();
  recipes.heights = std::move(*heights);
  ground::Waters waters = ground::plan_water_heights(std::move(dry->waters.surfaces), std::move(dry->waters.streams),
                                                     dry->covered, recipes.heights, report);
  recipes.surfaces = std::move(waters.surfaces);
  Result<scene::Header> header = make_header(spec, plane, dry->region, recipes);
  if (!header) return header.error();
  timer.finish();
  return Survey{extent,
                std::move(*header),
                std::move(recipes.heights),
                std::move(recipes.surfaces),
                std::move(waters.streams),
                of_diagnosed(std::move(dry->places), report)};
}

namespace {

/// One step of baking: a tile at a level, or the preparation that all levels of the tile share (no level).
struct BakeStep {
  std::size_t tile = 0;
  std::optional<std::size_t> level;
  bool exists = false;  ///< There is nothing to do.
};

/// All steps in order. The levels of a tile are separate steps, so none waits for the others; each tile is prepared
/// while the tile before it is baked.
std::vector<BakeStep> bake_steps(const scene::Scene& scene, std::size_t levels, const ExistsTile& exists) {
  std::vector<BakeStep> steps;
  const auto preparation = [&](std::size_t tile) {
    bool all_exist = true;
    for (std::size_t level = 0; level < levels; ++level) all_exist = all_exist && exists({tile, level});
    return BakeStep{tile, std::nullopt, all_exist};
  };
  const std::size_t tiles = scene.chunks.size();
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    if (tile == 0) steps.push_back(preparation(tile));
    if (tile + 1 < tiles) steps.push_back(preparation(tile + 1));
    for (std::size_t level = 0; level < levels; ++level) steps.push_back({tile, level, exists({tile, level})});
  }
  return steps;
}

struct TileInFlight {
  Once once;
  std::shared_ptr<bake::PreparedTile> prepared;
};

}  // namespace

Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> ladder_m, int threads, Report& report,
                        const OnProgress& on_progress, const TileHandlers& handlers, std::size_t most_instances) {
  assert(!ladder_m.empty() && ladder_m.front() > 0 && std::ranges::is_sorted(ladder_m));
  const std::vector<BakeStep> steps = bake_steps(scene, ladder_m.size(), handlers.exists);
  std::vector<Report> reports(steps.size());
  std::vector<TileInFlight> in_flight(scene.chunks.size());
  Result<Done> done = Done{};
  const auto prototypes = std::make_shared<const bake::PrototypeCache>(scene.header);
  const auto make = [&](std::size_t i) {
    TileInFlight& tile = in_flight[steps[i].tile];
    if (steps[i].exists) return;
    // the first thread that needs the tile prepares it; other threads join that work
    tile.once.call([&] {
      tile.prepared =
          bake::prepare(scene.header, scene.chunks[steps[i].tile], ladder_m, threads, prototypes, most_instances);
    });
    if (!steps[i].level) return;
    const ChunkLevel at{steps[i].tile, *steps[i].level};
    handlers.process(at, bake::bake_prepared(*tile.prepared, at.level, threads, reports[i]));
  };
  const auto hand_on = [&](std::size_t i) {
    if (!steps[i].level) return true;
    if (*steps[i].level + 1 == ladder_m.size()) in_flight[steps[i].tile].prepared.reset();
    const Report diagnosed = std::exchange(reports[i], {});
    report.append(diagnosed);
    done = handlers.take({steps[i].tile, *steps[i].level}, diagnosed);
    on_progress("bake", static_cast<double>(i + 1) / static_cast<double>(steps.size()));
    return static_cast<bool>(done);
  };
  for_each_in_order(steps.size(), threads, make, hand_on);
  return done;
}

Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> ladder_m, int threads, Report& report,
                        const OnProgress& on_progress, const OnBakedTile& take, std::size_t most_instances) {
  std::vector<std::optional<bake::BakedTile>> slots(scene.chunks.size() * ladder_m.size());
  const auto slot = [&](ChunkLevel at) -> auto& { return slots[at.chunk * ladder_m.size() + at.level]; };
  return bake_scene(scene, ladder_m, threads, report, on_progress,
                    {.exists = [](ChunkLevel) { return false; },
                     .process = [&](ChunkLevel at, bake::BakedTile&& tile) { slot(at) = std::move(tile); },
                     .take =
                         [&](ChunkLevel at, const Report&) {
                           const bake::BakedTile tile = *std::exchange(slot(at), std::nullopt);
                           return take(tile, at.level);
                         }},
                    most_instances);
}

namespace {

constexpr std::string_view kOsmCredit = "© OpenStreetMap contributors";

bool is_empty(const map::Features& f) {
  return f.tracks.empty() && f.footprints.empty() && f.areas.empty() && f.waterways.empty() && f.barriers.empty() &&
         f.points.empty();
}

Result<source::LonLatBox> choose_worthwhile_extent(const CompileSpec& spec, const source::OsmData& osm,
                                                   Report& report) {
  Result<source::LonLatBox> box = map::choose_extent(osm, spec.map.bbox, report);
  if (!box) return box;
  const map::Plane plane(spec.map.origin.value_or(map::default_origin(*box)));
  const bool has_box = spec.map.bbox || osm.header_box;
  const Result<Done> worthwhile = map::is_worth_baking(map::region_of(plane, *box), osm, has_box);
  if (!worthwhile) return worthwhile.error();
  return box;
}

ground::Waters plan_dry_waters(const map::Features& features, Report& report) {
  std::vector<ground::LandCoverPolygon> surfaces = ground::plan(features, report);
  return {std::move(surfaces), ground::plan_streams(features, report)};
}

ground::Waters plan_waters(ground::Waters dry, const map::Features& features, const map::Heightfield& heights,
                           Report& report) {
  return ground::plan_water_heights(std::move(dry.surfaces), std::move(dry.streams),
                                    ground::covered_waterways(features), heights, report);
}

/// Replaces each object by the known one of its id. Both are sorted by id.
template <typename Object>
void replace_known(std::vector<Object>& objects, const std::vector<Object>& known) {
  for (Object& object : objects) {
    const auto found = std::ranges::lower_bound(known, object.id, {}, &Object::id);
    if (found != known.end() && found->id == object.id) object = *found;
  }
}

ground::Waters surveyed_waters(ground::Waters waters, const Survey& survey) {
  std::ranges::stable_sort(waters.streams, {}, &roads::Strip::id);
  replace_known(waters.surfaces, survey.waters);
  replace_known(waters.streams, survey.streams);
  return waters;
}

/// The heights of the region. Error: heightmaps were given and none covers any of it.
Result<map::Heightfield> read_heights(const CompileSpec& spec, const map::Plane& plane, const Box2& region,
                                      Report& report) {
  if (spec.rasters.empty()) report.add(Code::kNoHeightmap, {});
  const source::LonLatBox window = map::lonlat_box_of(region, plane);
  const Result<std::vector<source::Raster>> rasters = source::read_heightmaps(spec.rasters, &window, report);
  if (!rasters) return rasters.error();
  return map::resample(*rasters, plane, region, report);
}

Result<surroundings::Surroundings> plan_surroundings(const CompileSpec& spec, const map::Plane& plane,
                                                     const scene::Recipes& recipes, const Box2& region) {
  const source::LonLatBox window = map::lonlat_box_of(region.widened(surroundings::kReach_m), plane);
  Report repeated;  // of what is diagnosed within the region already, or lies beyond it
  const Result<std::vector<source::Raster>> rasters =
      source::read_heightmaps(spec.rasters, &window, repeated, surroundings::kSampleSpacing_m);
  if (!rasters) return rasters.error();
  const auto is_sea = [](const ground::LandCoverPolygon& cover) { return cover.surface == map::LandCoverClass::kSea; };
  surroundings::Place place{.region = region, .tile_m = spec.tile_m};
  std::ranges::copy_if(recipes.surfaces, std::back_inserter(place.sea), is_sea);
  return surroundings::plan(*rasters, plane, place);
}

// All recipes that cover ground, but buildings.
scene::CoverRecipes cover_recipes_of(const scene::Recipes& recipes) {
  return {.areas = recipes.surfaces,
          .roads = recipes.roads,
          .junctions = recipes.junctions,
          .watercourses = recipes.watercourses,
          .footprints = {}};
}

ground::GradedTerrain grade_whole_map(const scene::Recipes& recipes, const Box2& region) {
  // slopes start at the outlines of junctions, as in tiles, so those of roads are needed too
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(cover_recipes_of(recipes));
  return ground::grade_terrain<structures::Span>(recipes.heights,
                                                 {.roads = recipes.roads,
                                                  .streams = recipes.watercourses,
                                                  .surfaces = surfaces,
                                                  .box = ground::graded_box(region, recipes.heights),
                                                  .has_kerbs = false},
                                                 recipes.structures.bridges, recipes.structures.tunnels);
}

std::vector<ground::LandCoverPolygon> pier_obstacles(const scene::Recipes& recipes, const map::Features& features) {
  scene::CoverRecipes cover = cover_recipes_of(recipes);
  for (const map::Footprint& footprint : features.footprints)
    cover.footprints.push_back(scene::footprint_surface(footprint.id, footprint.polygon));
  return scene::coarse_land_cover(cover);
}

/// Error: a tile in `only` is not a tile of the map.
Result<Done> are_tiles_of(const scene::Header& header, std::span<const scene::TileKey> only) {
  const std::vector<scene::TileKey> tiles = scene::tiles_of(header);
  for (const scene::TileKey tile : only) {
    if (std::ranges::binary_search(tiles, tile)) continue;
    return Error{"--only", fmt::format("the map has no tile {}; its tiles are {} to {}", to_string(tile),
                                       to_string(tiles.front()), to_string(tiles.back()))};
  }
  return Done{};
}

std::string file_name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// Whole metres.
double mean_height_m(const map::Heightfield& heights) {
  if (heights.heights.empty()) return 0;
  std::int64_t sum = 0;
  for (const std::int32_t height : heights.heights) sum += height;
  return std::floor(static_cast<double>(sum) / static_cast<double>(heights.heights.size()) * map::kHeightQuantum_m);
}

Result<scene::Header> make_header(const CompileSpec& spec, const map::Plane& plane, const Box2& region,
                                  const scene::Recipes& recipes) {
  const map::Heightfield& heights = recipes.heights;
  Result<surroundings::Surroundings> around = plan_surroundings(spec, plane, recipes, region);
  if (!around) return around.error();
  Result<sky::Sky> sky = sky::plan(plane.origin(), spec.time);
  if (!sky) return sky.error();
  sky::set_air(spec.air, *sky);
  sky->ground_m = mean_height_m(heights);
  if (!spec.clouds.empty()) {
    Result<std::vector<sky::CloudLayer>> clouds = sky::read_clouds(spec.clouds, sky->ground_m, spec.seed);
    if (!clouds) return clouds.error();
    sky->clouds = std::move(*clouds);
  }
  scene::Header header{.origin = plane.origin(),
                       .region = region,
                       .tile_m = spec.tile_m,
                       .seed = spec.seed,
                       .resampling_error_m = heights.resampling_error_m,
                       .sky = std::move(*sky),
                       .sources = {file_name_of(spec.map_path)},
                       .attributions = {std::string(kOsmCredit)},
                       .snow_line_m = spec.snow_line_m,
                       .around = std::move(*around)};
  for (const source::RasterSpec& raster : spec.rasters) header.sources.push_back(file_name_of(raster.path));
  for (const source::RasterSpec& raster : spec.rasters) {
    const bool is_new = std::ranges::find(header.attributions, raster.credit) == header.attributions.end();
    if (!raster.credit.empty() && is_new) header.attributions.push_back(raster.credit);
  }
  if (const Result<Done> done = are_tiles_of(header, spec.only); !done) return done.error();
  return header;
}

Result<std::vector<buildings::RuleText>> rules_for(const CompileSpec& spec,
                                                   const std::vector<buildings::Building>& buildings) {
  std::vector<buildings::RuleText> available;
  if (!spec.rules_folder.empty()) {
    Result<std::vector<source::TextFile>> own = source::read_texts(spec.rules_folder, ".cga");
    if (!own) return own.error();
    for (source::TextFile& file : *own) available.push_back({std::move(file.name), std::move(file.text)});
  }
  for (const buildings::RuleText& rule : buildings::shipped_rules()) {
    const auto has_its_name = [&](const buildings::RuleText& own) { return own.name == rule.name; };
    if (std::ranges::none_of(available, has_its_name)) available.push_back(rule);
  }
  return buildings::rules_for(buildings::styles_of(buildings), available);
}

}  // namespace
}  // namespace citykiln
