#include "compiler/pipeline.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "compiler/assume/assume.h"
#include "compiler/buildings/plan.h"
#include "compiler/climate/climate_at.h"
#include "compiler/contract/joined.h"
#include "compiler/edits/with_edits.h"
#include "compiler/fields/add_fields.h"
#include "compiler/ground/correction/corrected_land.h"
#include "compiler/ground/correction/known_waters.h"
#include "compiler/ground/cover/close_gaps.h"
#include "compiler/ground/landforms/plan_landforms.h"
#include "compiler/ground/levelling/airports.h"
#include "compiler/ground/profiles/plan_paths.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/water/pool_rims.h"
#include "compiler/lots/add_yards.h"
#include "compiler/make_clip.h"
#include "compiler/make_header.h"
#include "compiler/map/locate.h"
#include "compiler/map/ways/private_ways.h"
#include "compiler/pitches/plan.h"
#include "compiler/plants/plan.h"
#include "compiler/props/plan.h"
#include "compiler/roads/plan.h"
#include "compiler/scene/assemble.h"
#include "compiler/source/read_osm.h"
#include "compiler/structures/plan.h"
#include "compiler/structures/risers.h"
#include "compiler/things/plan.h"
#include "compiler/vacant/uses.h"
#include "compiler/whole_map.h"
#include "compiler/wires/contact_wires.h"
#include "compiler/wires/plan.h"

namespace citykiln {
namespace {

// The things and species that the map is read with: those of citykiln, and those of the folders that the spec names.
struct Tables {
  things::Catalogue catalogue;
  plants::UserSpecies species;
};

Result<Tables> read_tables(const CompileSpec& spec) {
  Result<things::Catalogue> catalogue = read_things(spec);
  if (!catalogue) return catalogue.error();
  Result<plants::UserSpecies> species = read_species(spec.species_folder);
  if (!species) return species.error();
  return Tables{std::move(*catalogue), std::move(*species)};
}

map::Options reading_of(const CompileSpec& spec, const Tables& tables) {
  map::Options reading = spec.map;
  reading.things = &tables.catalogue.table, reading.user_plants = &tables.species.for_map;
  return reading;
}

// A map in the plane.
struct Located {
  source::OsmData osm;
  map::Plane plane;
  map::Features map;
  map::Heightfield heights;
};

// Reads a map and mends it by the edits of the spec. The survey has reported the lines of a region.
Result<source::OsmData> read_map(const CompileSpec& spec, const std::string& extract, const Survey* survey,
                                 const source::OwnsPlace& owns, Report& report) {
  Result<source::OsmData> osm = source::read_osm(extract, spec.threads, report, owns);
  if (!osm || !spec.edits) return osm;
  edits::EditedMap edited = edits::with_edits(std::move(*osm), *spec.edits, report, owns);
  if (!survey) edits::report_lines(*spec.edits, edited.had_effect, report);
  return std::move(edited.map);
}

// Reads a map and its heights, projects it to the plane and classifies its elements.
Result<Located> locate(const CompileSpec& spec, const std::string& extract, const Survey* survey,
                       const source::OwnsPlace& owns, const Tables& tables, StageTimer& timer, Report& report) {
  timer.enter("read map");
  Result<source::OsmData> osm = read_map(spec, extract, survey, owns, report);
  if (!osm) return osm.error();
  timer.enter("project and classify");
  const Result<source::LonLatBox> box = survey ? survey->extent : choose_worthwhile_extent(spec, *osm, report);
  if (!box) return box.error();
  map::Plane plane(survey ? survey->header.origin : spec.map.origin.value_or(map::default_origin(*box)));
  map::Features map = map::locate(*osm, plane, *box, reading_of(spec, tables), report);
  if (!survey && is_empty(map)) return Error{spec.map_path, "contains nothing to compile in this area"};
  timer.enter("terrain heights");
  Result<map::Heightfield> heights = survey ? survey->heights : read_heights(spec, plane, map.extent, report);
  if (!heights) return heights.error();
  return Located{std::move(*osm), std::move(plane), std::move(map), std::move(*heights)};
}

// The facts of the map that lots need besides its features and roads.
struct LotFacts {
  lots::ClimateAt climate_at;         // of places in the plane
  std::vector<OsmId> private_ways{};  // sorted
};

// Returns the facts if houses or yards are wanted. plane must outlive them. O(ways).
LotFacts lot_facts_of(const CompileSpec& spec, const source::OsmData& osm, const map::Plane& plane) {
  LotFacts facts{.climate_at = [&plane](Vec2 at) {
    const LonLat place = plane.backward(at);
    return climate::climate_at(place.lon_deg, place.lat_deg);
  }};
  if (spec.fill_lots || has(spec.assume, Assumption::kYards)) facts.private_ways = map::private_ways(osm);
  return facts;
}

lots::LotInputs lot_inputs(const CompileSpec& spec, const LotFacts& facts, const roads::RoadPlan& roads) {
  return {.roads = roads.roads,
          .junctions = roads.junctions,
          .private_ways = facts.private_ways,
          .climate_at = facts.climate_at,
          .seed = spec.seed,
          .threads = spec.threads};
}

// The assumptions about streets that count the houses beside them, and the lines that lots keep from.
constexpr Assumptions kOfStreets = bit_of(Assumption::kPavements) | bit_of(Assumption::kVerges) |
                                   bit_of(Assumption::kParking) | bit_of(Assumption::kCurves);

// The footprints with the houses that fill lots, beside the streets as they would be without them; nothing without
// spec.fill_lots. Later stages count them as mapped ones.
Result<std::optional<std::vector<map::Footprint>>> filled_lots(const CompileSpec& spec, const LotFacts& facts,
                                                               const map::FeatureView& mapped, Report& report) {
  if (!spec.fill_lots) return std::optional<std::vector<map::Footprint>>{};
  const Result<lots::HouseRules> rules = house_rules_for(spec);
  if (!rules) return rules.error();
  Report without_houses;
  const assume::Assumed streets =
      assume::assume(mapped, {Assumptions(spec.assume & kOfStreets), spec.seed, {}}, without_houses);
  const roads::RoadPlan roads = roads::plan(seen_with(mapped, streets), without_houses);
  return std::optional(lots::with_houses(mapped, lot_inputs(spec, facts, roads), *rules, report));
}

map::FeatureView seen_with(map::FeatureView features, const std::optional<std::vector<map::Footprint>>& filled) {
  if (filled) features.footprints = *filled;
  return features;
}

// The yards; nothing where they are not assumed.
std::optional<lots::Yards> yards_of(const CompileSpec& spec, const LotFacts& facts, const map::FeatureView& features,
                                    const roads::RoadPlan& roads, Report& report) {
  if (!has(spec.assume, Assumption::kYards)) return std::nullopt;
  return lots::with_yards(features, lot_inputs(spec, facts, roads), report);
}

// The fields, and the hedges beside roads; nothing where neither is assumed.
std::optional<fields::Fields> fields_of(const CompileSpec& spec, const LotFacts& facts, const Located& located,
                                        const map::FeatureView& features, const roads::RoadPlan& roads,
                                        Report& report) {
  if (!has(spec.assume, Assumption::kFields) && !has(spec.assume, Assumption::kRoadsides)) return std::nullopt;
  const map::Plane& plane = located.plane;
  const fields::RuleAt rule_at = [&](Vec2 at) { return fields::field_rule_at(plane.backward(at)); };
  const std::function<map::CountryGroup(Vec2)> country_at = [&](Vec2 at) {
    return map::country_group_at(plane.backward(at));
  };
  return fields::with_fields(features,
                             {.roads = roads.roads,
                              .junctions = roads.junctions,
                              .heights = located.heights,
                              .rule_at = rule_at,
                              .climate_at = facts.climate_at,
                              .country_at = country_at,
                              .assumed = spec.assume,
                              .seed = spec.seed,
                              .threads = spec.threads},
                             report);
}

// The land cover of a whole map, and its heights.
struct PlannedGround {
  map::Heightfield heights;                        // with level airports, corrected by roads
  std::vector<ground::LandCoverPolygon> surfaces;  // with the rims of pools
  std::vector<roads::Strip> streams;
  std::vector<ground::Landform> landforms;
  ground::Profiles profiles;
  ground::ProfileMeasures measured;
};

// The profiles of roads and rails, and the land that they correct. Landforms are planned before and after that: roads
// need their heights.
void plan_lines(const map::FeatureView& features, const roads::RoadPlan& planned, PlannedGround& ground,
                Report& report) {
  Report before;
  const std::vector<ground::Landform> landforms =
      ground::plan_landforms(features, ground.surfaces, ground.streams, ground.heights, before);
  ground::LineProfiles lines = ground::plan_line_profiles(features, planned.roads, planned.junctions, ground.streams,
                                                          ground.surfaces, ground.heights, report, landforms);
  ground.profiles = std::move(lines.profiles);
  const std::vector<ground::KnownLine> waters = ground::known_waters(ground.surfaces, ground.streams);
  lines.known.insert(lines.known.end(), waters.begin(), waters.end());
  ground.heights = ground::corrected_land(ground.heights, lines.known);
  ground.landforms = ground::plan_landforms(features, ground.surfaces, ground.streams, ground.heights, report);
}

PlannedGround plan_ground(const CompileSpec& spec, const map::FeatureView& features, const roads::RoadPlan& planned,
                          const map::Heightfield& heights, const Survey* survey, StageTimer& timer, Report& report) {
  PlannedGround ground;
  timer.enter("land cover and water");
  ground::Waters waters = survey ? surveyed_waters(features, *survey, report) : plan_waters(features, heights, report);
  ground.surfaces = std::move(waters.surfaces), ground.streams = std::move(waters.streams);
  ground.heights = ground::with_level_airports(heights, features);
  timer.enter("road heights");
  plan_lines(features, planned, ground, report);
  const ground::TerrainWithoutRoads terrain{ground.streams, ground.surfaces, ground.heights, ground.landforms};
  ground.profiles = ground::plan_paths(features, std::move(ground.profiles), terrain, report);
  ground.measured = ground::measure_profiles(features, ground.profiles);
  ground.surfaces = ground::with_pool_rims(std::move(ground.surfaces));
  if (has(spec.assume, Assumption::kPavements))
    ground.surfaces = ground::with_closed_gaps(std::move(ground.surfaces), planned.roads);
  return ground;
}

// The ground of a whole map, and what carries roads above and below it.
struct Land {
  const WholeGround& ground;
  std::span<const roads::Road> roads;  // with heights and risers
  const structures::Structures& structures;
  const ground::GradedTerrain& graded;
  const roads::RoadPlan& planned;
};

// The objects that stand on the ground, and the wires above it.
struct Standing {
  std::vector<buildings::Building> buildings;
  plants::Plants plants;
  props::Props props;
  pitches::PitchPlan pitches;
  things::ThingPlan things;
  std::vector<props::Barrier> barriers;  // those of props, and railings
  std::vector<wires::WireSpan> wire_spans;
};

Result<things::ThingPlan> things_of(const CompileSpec& spec, const map::FeatureView& features, const Land& land,
                                    std::span<const buildings::Building> buildings,
                                    std::span<const map::ThingFeature> equipment, const things::Catalogue& catalogue,
                                    Report& report) {
  const std::vector<ground::LandCoverPolygon> cover = thing_obstacles(land.ground, buildings);
  return things::plan(features,
                      {.catalogue = catalogue,
                       .equipment = equipment,
                       .cover = cover,
                       .roads = land.roads,
                       .junctions = land.ground.junctions,
                       .bridges = land.structures.bridges,
                       .buildings = buildings,
                       .ground = land.graded,
                       .assumed = spec.assume,
                       .seed = spec.seed},
                      report);
}

// The wires of power lines and contact lines.
std::vector<wires::WireSpan> wires_of(const CompileSpec& spec, const map::FeatureView& features, const Land& land,
                                      const things::ThingPlan& things, Report& report) {
  std::vector<wires::WireSpan> power_lines = wires::plan(features,
                                                         {.mapped = things.mapped,
                                                          .things = things.things,
                                                          .beyond = things.beyond,
                                                          .kinds = things.kinds,
                                                          .roads = land.roads,
                                                          .bridges = land.structures.bridges,
                                                          .ground = land.graded,
                                                          .seed = spec.seed},
                                                         report);
  return joined(std::move(power_lines), wires::contact_spans(things.contact_lines, land.graded, report),
                wires::order_of);
}

// Returns the number of those buildings that the report counts.
std::uint64_t counted(std::span<const buildings::Building> buildings, const Report& report) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(buildings, [&](const buildings::Building& b) { return report.counts(b.id.osm); }));
}

// Leaves out what stands beyond a clip, and counts it. Does nothing without a clip.
void leave_out_beyond(const scene::Clip& clip, Standing& standing, Report& report) {
  if (clip.empty()) return;
  StandingRecipes all{.buildings = std::move(standing.buildings),
                      .trees = std::move(standing.plants.trees),
                      .lamps = std::move(standing.props.lamps),
                      .things = std::move(standing.things.things),
                      .barriers = std::move(standing.barriers),
                      .wire_spans = std::move(standing.wire_spans)};
  Account account;
  account.in = counted(all.buildings, report);
  StandingRecipes kept = within_clip(std::move(all), clip);
  account.out = counted(kept.buildings, report);
  if (account.in > account.out) account.dropped[Code::kOutsideBounds] = account.in - account.out;
  report.account("clip", "building") = account;
  standing.buildings = std::move(kept.buildings), standing.plants.trees = std::move(kept.trees);
  standing.props.lamps = std::move(kept.lamps), standing.things.things = std::move(kept.things);
  standing.barriers = std::move(kept.barriers), standing.wire_spans = std::move(kept.wire_spans);
}

// Plans the objects that stand on the ground inside of a clip, and the wires.
Result<Standing> plan_standing(const CompileSpec& spec, const map::FeatureView& features, const Land& land,
                               const Tables& tables, const scene::Clip& clip, StageTimer& timer, Report& report) {
  Standing standing;
  timer.enter("buildings");
  standing.buildings =
      buildings::plan(features, land.graded, report, land.planned.passageways, land.structures.bridges);
  timer.enter("plants");
  standing.plants = plants::plan(features, land.ground.surfaces, land.roads, land.ground.heights, report, spec.assume,
                                 tables.species.table);
  timer.enter("props");
  standing.props = props::plan(features, land.roads, report);
  timer.enter("things");
  standing.pitches = pitches::plan(features, tables.catalogue.table);
  Result<things::ThingPlan> things =
      things_of(spec, features, land, standing.buildings, standing.pitches.equipment, tables.catalogue, report);
  if (!things) return things.error();
  standing.things = std::move(*things);
  standing.barriers = standing.props.barriers;
  standing.barriers = joined(std::move(standing.barriers), standing.things.railings, props::order_of);
  timer.enter("wires");
  standing.wire_spans = wires_of(spec, features, land, standing.things, report);
  leave_out_beyond(clip, standing, report);
  return standing;
}

// The header with the rules, species and things of the scene.
Result<scene::Header> header_with_texts(scene::Header header, const CompileSpec& spec, const Standing& standing,
                                        const Tables& tables, std::span<const map::AreaFeature> areas) {
  Result<std::vector<buildings::RuleText>> rules = rules_for(spec, standing.buildings);
  if (!rules) return rules.error();
  header.rules = std::move(*rules);
  header.species = plants::species_texts_for(standing.plants, has_hedges(standing.props), tables.species.texts,
                                             tables.species.table);
  header.things =
      things::texts_for(tables.catalogue, standing.things.kinds, standing.things.things, vacant::uses_on(areas));
  return header;
}

/// Compiles a whole map; with a survey, the tiles of spec.only from an extract that covers their surroundings.
Result<CompileResult> compile_part(const CompileSpec& spec, const std::string& extract, const Survey* survey,
                                   const source::OwnsPlace& owns, const OnProgress& on_progress) {
  assert(!spec.map_path.empty() && spec.tile_m > 0 && std::ranges::is_sorted(spec.only));
  StageTimer timer(on_progress);
  Report report;
  const Result<Tables> tables = read_tables(spec);
  if (!tables) return tables.error();

  // read the map and locate it: in the plane, with its elements classified
  const Result<Located> located = locate(spec, extract, survey, owns, *tables, timer, report);
  if (!located) return located.error();
  const auto& [osm, plane, map, heights] = *located;

  // assume what it does not say
  timer.enter("roads");
  const LotFacts lot_facts = lot_facts_of(spec, osm, plane);
  const Result<std::optional<std::vector<map::Footprint>>> filled = filled_lots(spec, lot_facts, map, report);
  if (!filled) return filled.error();
  const map::FeatureView mapped = seen_with(map, *filled);
  const assume::Assumed assumed = assume::assume(
      mapped, {spec.assume, spec.seed, [&located](Vec2 at) { return located->plane.backward(at); }}, report);
  const map::FeatureView streets = seen_with(mapped, assumed);

  // roads, and the lots between them
  const roads::RoadPlan planned = roads::plan(streets, report);
  if (has(spec.assume, Assumption::kYards)) timer.enter("lots");
  const std::optional<lots::Yards> yards = yards_of(spec, lot_facts, streets, planned, report);
  const map::FeatureView lived_in = yards ? seen_with(streets, *yards) : streets;
  const std::optional<fields::Fields> farmed = fields_of(spec, lot_facts, *located, lived_in, planned, report);
  const map::FeatureView features = farmed ? seen_with(lived_in, *farmed) : lived_in;

  // the ground: land cover and all heights
  const auto [land_heights, surfaces, streams, landforms, profiles, measured] =
      plan_ground(spec, features, planned, heights, survey, timer, report);
  const WholeGround ground{.heights = land_heights,
                           .surfaces = surfaces,
                           .roads = profiles.roads,
                           .junctions = planned.junctions,
                           .streams = streams,
                           .landforms = landforms};

  // bridges, tunnels and stairs, which meet the graded terrain
  timer.enter("bridges and tunnels");
  const structures::Structures spans = structures::plan(features, profiles.off_ground, land_heights, report);
  const ground::GradedTerrain graded = grade_whole_map(ground, spans, features.extent);
  const std::vector<roads::Road> roads = structures::with_risers(profiles.roads, features.tracks, graded, report);
  const structures::Structures structures =
      structures::with_piers(spans, graded, pier_obstacles(ground, features.footprints), features.extent, report);

  // what stands on the ground
  const Land land{.ground = ground, .roads = roads, .structures = structures, .graded = graded, .planned = planned};
  const scene::Clip clip = survey ? survey->header.clip : make_clip(spec, plane);
  const Result<Standing> standing = plan_standing(spec, features, land, *tables, clip, timer, report);
  if (!standing) return standing.error();
  const auto& [buildings, plants, props, pitches, things, barriers, wire_spans] = *standing;

  // the sky, and the land around the extent
  timer.enter("surroundings");
  const Result<scene::Header> around =
      survey ? survey->header : make_header(spec, plane, features.extent, {heights, surfaces, buildings, map.coasts});
  if (!around) return around.error();

  // the scene: all recipes, by tile
  timer.enter("sort into tiles");
  const Result<scene::Header> header = header_with_texts(*around, spec, *standing, *tables, features.areas);
  if (!header) return header.error();
  const std::span<const lots::Yard> yard_recipes = yards ? yards->recipes : std::span<const lots::Yard>{};
  scene::Scene scene = scene::assemble({.heights = land_heights,
                                        .buildings = buildings,
                                        .bridges = structures.bridges,
                                        .tunnels = structures.tunnels,
                                        .roads = roads,
                                        .watercourses = streams,
                                        .landforms = landforms,
                                        .barriers = barriers,
                                        .trees = plants.trees,
                                        .tree_rows = plants.rows,
                                        .lamps = props.lamps,
                                        .things = things.things,
                                        .wire_spans = wire_spans,
                                        .surfaces = surfaces,
                                        .junctions = planned.junctions,
                                        .pitches = pitches.pitches,
                                        .woods = plants.woods,
                                        .plantings = plants.plantings,
                                        .corridors = plants.corridors,
                                        .yards = yard_recipes,
                                        .texts = map.texts},
                                       *header, spec.only, spec.threads);
  map::remove_diagnoses_outside(osm, plane, features.extent, report);
  map::Places places = map::places_of(osm, report);
  map::LayerTags layer_tags = map::layer_tags_of(osm, report);
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
