#include "compiler/pipeline.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "compiler/assume/assume.h"
#include "compiler/buildings/plan.h"
#include "compiler/climate/climate_at.h"
#include "compiler/ground/landforms/plan_landforms.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/water/pool_rims.h"
#include "compiler/lots/add_yards.h"
#include "compiler/make_header.h"
#include "compiler/map/locate.h"
#include "compiler/map/passageways.h"
#include "compiler/map/private_ways.h"
#include "compiler/pitches/plan.h"
#include "compiler/plants/plan.h"
#include "compiler/props/plan.h"
#include "compiler/roads/fit_assumed_widths.h"
#include "compiler/roads/plan.h"
#include "compiler/roads/width_limits/limit_widths.h"
#include "compiler/scene/assemble.h"
#include "compiler/source/read_osm.h"
#include "compiler/structures/plan.h"
#include "compiler/structures/plan_parapet_gaps.h"
#include "compiler/structures/plan_piers.h"
#include "compiler/structures/risers.h"
#include "compiler/structures/within_extent.h"
#include "compiler/things/contact_masts.h"
#include "compiler/things/plan.h"
#include "compiler/things/railings.h"
#include "compiler/whole_map.h"
#include "compiler/wires/contact_wires.h"
#include "compiler/wires/plan.h"

namespace citykiln {
namespace {

// The class of climate of places in the plane.
lots::ClimateAt climate_of_places(const map::Plane& plane) {
  return [&plane](Vec2 at) {
    const map::LonLat place = plane.backward(at);
    return climate::climate_at(place.lon_deg, place.lat_deg);
  };
}

// Roads with their junctions, not wider than the buildings beside them allow.
struct RoadPlan {
  std::vector<roads::Road> roads;
  std::vector<roads::Junction> junctions;
};

RoadPlan plan_roads(const map::Features& features, Report& report) {
  RoadPlan plan{roads::plan(features, report), {}};
  plan.junctions = roads::plan_junctions(plan.roads, report);
  plan.roads = roads::limit_widths(std::move(plan.roads), plan.junctions, features.footprints,
                                   roads::ways_through_buildings(features), report);
  return plan;
}

// The assumptions about streets that count the houses beside them.
constexpr Assumptions kOfStreets =
    bit_of(Assumption::kPavements) | bit_of(Assumption::kVerges) | bit_of(Assumption::kParking);

// Adds the houses that fill lots, beside the streets as they would be without them. Later assumptions count
// them as mapped ones.
Result<map::Features> with_filled_lots(map::Features features, const CompileSpec& spec, const source::OsmData& osm,
                                       const map::Plane& plane, Report& report) {
  const Result<lots::HouseRules> rules = house_rules_for(spec);
  if (!rules) return rules.error();
  Report without_houses;
  map::Features streets = assume::assume(features, {Assumptions(spec.assume & kOfStreets), spec.seed}, without_houses);
  streets.passageways = map::plan_passageways(streets, without_houses);
  const RoadPlan planned = plan_roads(streets, without_houses);
  const lots::ClimateAt climate_at = climate_of_places(plane);
  const std::vector<OsmId> private_ways = map::private_ways(osm);
  const lots::LotInputs inputs{.roads = planned.roads,
                               .junctions = planned.junctions,
                               .private_ways = private_ways,
                               .climate_at = climate_at,
                               .seed = spec.seed,
                               .threads = spec.threads};
  return lots::with_houses(std::move(features), inputs, *rules, report);
}

map::Features with_yards(map::Features features, const CompileSpec& spec, const source::OsmData& osm,
                         const map::Plane& plane, const scene::Recipes& recipes, Report& report) {
  const lots::ClimateAt climate_at = climate_of_places(plane);
  const std::vector<OsmId> private_ways = map::private_ways(osm);
  const lots::LotInputs inputs{.roads = recipes.roads,
                               .junctions = recipes.junctions,
                               .private_ways = private_ways,
                               .climate_at = climate_at,
                               .seed = spec.seed,
                               .threads = spec.threads};
  return lots::with_yards(std::move(features), inputs, report);
}

/// Compiles a whole map; with a survey, the tiles of spec.only from an extract that covers their surroundings.
Result<CompileResult> compile_part(const CompileSpec& spec, const std::string& extract, const Survey* survey,
                                   const source::OwnsPlace& owns, const OnProgress& on_progress) {
  assert(!spec.map_path.empty() && spec.tile_m > 0 && std::ranges::is_sorted(spec.only));
  StageTimer timer(on_progress);
  Report report;
  scene::Recipes recipes;

  const Result<things::Catalogue> catalogue = read_things(spec);
  if (!catalogue) return catalogue.error();
  const Result<plants::OwnSpecies> own_species = read_species(spec.species_folder);
  if (!own_species) return own_species.error();
  map::Options reading = spec.map;
  reading.things = &catalogue->table, reading.own_plants = &own_species->for_map;

  // read the map, project it to the plane and classify its elements
  timer.enter("read map");
  const Result<source::OsmData> osm = source::read_osm(extract, spec.threads, report, owns);
  if (!osm) return osm.error();
  timer.enter("project and classify");
  const Result<source::LonLatBox> box = survey ? survey->extent : choose_worthwhile_extent(spec, *osm, report);
  if (!box) return box.error();
  const map::Plane plane(survey ? survey->header.origin : spec.map.origin.value_or(map::default_origin(*box)));
  map::Features features = map::locate(*osm, plane, *box, reading, report);
  if (!survey && is_empty(features)) return Error{spec.map_path, "contains nothing to compile in this area"};

  // resample the heightmaps
  timer.enter("terrain heights");
  Result<map::Heightfield> heights = survey ? survey->heights : read_heights(spec, plane, features.extent, report);
  if (!heights) return heights.error();
  recipes.heights = std::move(*heights);

  // plan roads, land cover and their heights
  timer.enter("roads");
  // assumptions measure the room beside the fitted kerbs
  features.tracks = roads::fit_assumed_widths(features);
  if (spec.fill_lots) {
    Result<map::Features> filled = with_filled_lots(std::move(features), spec, *osm, plane, report);
    if (!filled) return filled.error();
    features = std::move(*filled);
  }
  features = assume::assume(std::move(features), {spec.assume, spec.seed}, report);
  features.passageways = map::plan_passageways(features, report);
  RoadPlan planned = plan_roads(features, report);
  recipes.roads = std::move(planned.roads), recipes.junctions = std::move(planned.junctions);
  if (has(spec.assume, Assumption::kYards)) {
    timer.enter("lots");
    features = with_yards(std::move(features), spec, *osm, plane, recipes, report);
  }
  timer.enter("land cover and water");
  ground::Waters waters = survey ? surveyed_waters(plan_dry_waters(features, report), *survey)
                                 : plan_waters(plan_dry_waters(features, report), features, recipes.heights, report);
  recipes.surfaces = std::move(waters.surfaces), recipes.watercourses = std::move(waters.streams);
  recipes.landforms = ground::plan_landforms(features, recipes.surfaces, recipes.watercourses, recipes.heights, report);
  timer.enter("road heights");
  ground::Profiles profiles =
      ground::plan_profiles(features, std::move(recipes.roads), recipes.junctions, recipes.watercourses,
                            recipes.surfaces, recipes.heights, report, 1, recipes.landforms);
  const ground::ProfileMeasures measured = ground::measure_profiles(features, profiles);
  recipes.roads = std::move(profiles.roads);
  recipes.surfaces = ground::with_pool_rims(std::move(recipes.surfaces));

  // plan bridges and tunnels, then the objects that stand on the ground
  timer.enter("bridges and tunnels");
  recipes.structures = structures::plan(features, profiles.off_ground, recipes.heights, report);
  recipes.structures.bridges = structures::find_parapet_gaps(std::move(recipes.structures.bridges));
  const ground::GradedTerrain graded = grade_whole_map(recipes, features.extent);
  recipes.roads = structures::with_risers(std::move(recipes.roads), features.tracks, graded, report);
  recipes.structures.bridges =
      structures::place_piers(std::move(recipes.structures.bridges), graded, pier_obstacles(recipes, features), report);
  recipes.structures = structures::within_extent(std::move(recipes.structures), features.extent, report);
  timer.enter("buildings");
  recipes.buildings = buildings::plan(features, graded, report, recipes.structures.bridges);
  timer.enter("plants");
  recipes.plants = plants::plan(features, recipes.surfaces, recipes.roads, recipes.heights, report, own_species->table);
  timer.enter("props");
  recipes.props = props::plan(features, report);
  timer.enter("things");
  const std::vector<ground::LandCoverPolygon> cover = thing_obstacles(recipes);
  if (has(spec.assume, Assumption::kRailings)) {
    std::vector<props::Barrier> railings = things::assumed_railings(features,
                                                                    {.cover = cover,
                                                                     .roads = recipes.roads,
                                                                     .bridges = recipes.structures.bridges,
                                                                     .buildings = recipes.buildings,
                                                                     .ground = graded},
                                                                    report);
    recipes.props.barriers = props::with_more(std::move(recipes.props.barriers), std::move(railings));
  }
  recipes.fields = pitches::plan(features);
  for (map::ThingFeature& thing : pitches::things_of(recipes.fields, catalogue->table, features))
    features.things.push_back(std::move(thing));
  things::ContactLines contact_lines;
  if (has(spec.assume, Assumption::kMasts))
    contact_lines = things::plan_contact_lines(
        features, {.cover = cover, .roads = recipes.roads, .bridges = recipes.structures.bridges, .ground = graded},
        report);
  std::erase_if(features.things, [&](const auto& thing) { return contact_lines.replaced.contains(thing.id.osm); });
  Result<things::Kinds> kinds = things::Kinds{};
  auto names = things::kind_names(features, catalogue->table);
  for (const things::Thing& mast : contact_lines.masts) names.insert(mast.form.kind);
  if (!names.empty()) {
    kinds = things::kinds_of(*catalogue, names);
    if (!kinds) return kinds.error();
    recipes.things =
        things::plan(features, recipes.roads, recipes.junctions, cover, recipes.buildings, *kinds, spec.seed, report);
    recipes.things = things::with_more(std::move(recipes.things), contact_lines.masts);
  }
  timer.enter("wires");
  const std::vector<things::Thing> supports_beyond = things::plan_supports_beyond(features, *kinds, spec.seed);
  recipes.wire_spans = wires::plan(features,
                                   {.things = recipes.things,
                                    .beyond = supports_beyond,
                                    .kinds = *kinds,
                                    .roads = recipes.roads,
                                    .bridges = recipes.structures.bridges,
                                    .ground = graded,
                                    .seed = spec.seed},
                                   report);
  recipes.wire_spans =
      wires::with_more(std::move(recipes.wire_spans), wires::contact_spans(contact_lines, graded, report));

  // plan the land around the extent, describe the sky and the sources
  timer.enter("surroundings");
  Result<scene::Header> header = survey ? survey->header : make_header(spec, plane, features.extent, recipes);
  if (!header) return header.error();

  // sort all recipes into tiles
  timer.enter("sort into tiles");
  recipes.texts = features.texts;
  Result<std::vector<buildings::RuleText>> rules = rules_for(spec, recipes.buildings);
  if (!rules) return rules.error();
  header->rules = std::move(*rules);
  header->species =
      plants::species_texts_for(recipes.plants, has_hedges(recipes.props), own_species->texts, own_species->table);
  header->things = things::texts_for(*catalogue, *kinds, recipes.things);
  scene::Scene scene = scene::assemble(recipes, *header, spec.only, spec.threads);
  map::remove_diagnoses_outside(*osm, plane, features.extent, report);
  map::Places places = map::places_of(*osm, report);
  map::LayerTags layer_tags = map::layer_tags_of(*osm, report);
  // all tiles that are baked belong to the region
  report.lift_limit();
  return CompileResult{std::move(scene), std::move(report), measured,
                       timer.finish(),   std::move(places), std::move(layer_tags)};
}

}  // namespace

Result<CompileResult> compile(const CompileSpec& spec, const OnProgress& on_progress) {
  return compile_part(spec, spec.map_path, nullptr, {}, on_progress);
}

Result<CompileResult> compile_region(const CompileSpec& spec, const std::string& extract, const Survey& survey,
                                     const source::OwnsPlace& owns, const OnProgress& on_progress) {
  return compile_part(spec, extract, &survey, owns, on_progress);
}

}  // namespace citykiln
