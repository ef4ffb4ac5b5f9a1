#include "compiler/plants/plan.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"
#include "compiler/plants/placing/row_heading.h"
#include "compiler/plants/plant_size.h"

namespace citykiln::plants {
namespace {

using map::LandCoverClass;

struct WoodRow {
  LandCoverClass surface;
  PlantCommunity community;
  std::uint16_t trees_per_ha;
  double height_m;
};
constexpr WoodRow kWoods[] = {
#define WOOD(surface, community, trees_per_ha, height_m) \
  {LandCoverClass::surface, PlantCommunity::community, trees_per_ha, height_m},
#include "compiler/plants/wood_defaults.inc"
};

struct PlantingRow {
  LandCoverClass surface;
  SpeciesMix species_mix;
  double row_spacing_m, plant_spacing_m, height_m;
};
constexpr PlantingRow kPlantings[] = {
#define PLANTING(surface, species, row_spacing_m, plant_spacing_m, height_m) \
  {LandCoverClass::surface, species_mix_of(species), row_spacing_m, plant_spacing_m, height_m},
#include "compiler/plants/planting_defaults.inc"
};

// Crops of farmland whose tags name them.
constexpr PlantingRow kCrops[] = {{LandCoverClass::kFarmland, species_mix_of(Species::kWheat), 0.5, 0.375, 0.875},
                                  {LandCoverClass::kFarmland, species_mix_of(Species::kMaize), 0.75, 0.375, 2.25},
                                  {LandCoverClass::kFarmland, species_mix_of(Species::kGrass), 1, 1, 0.375}};

// Distance of an avenue's trunks from the kerb.
constexpr double kBehindKerb_m = 1;

double in_eighths(double v) { return std::floor(v * 8 + 0.5) / 8; }

// The tagged height, else from other tagged sizes; a tree of unknown species is sized as the most common one.
double planned_height_m(double tagged_m, SpeciesMix species_mix, const map::PlantTags& plant_tags,
                        const SpeciesTable& table) {
  if (tagged_m > 0) return tagged_m;
  const Species species = is_single_species(species_mix) ? single_species(species_mix) : Species::kLime;
  return height_from_tags_m(table[species], plant_tags);
}

std::vector<Tree> plan_trees(const map::FeatureView& features, const SpeciesTable& table, Report& report) {
  std::vector<Tree> trees;
  Account account;
  for (const map::PointFeature& point : features.points) {
    if (point.kind != map::PointKind::kTree) continue;
    account.in += report.counts(point.id.osm), account.out += report.counts(point.id.osm);
    // trees of yards are derived from buildings
    const PlantCommunity usual = is_derived(point.id) ? PlantCommunity::kGardenTrees : PlantCommunity::kTownTrees;
    const SpeciesMix species_mix = species_mix_for(point.plant_tags, species_mix_of(usual));
    trees.push_back({.id = point.id,
                     .at = point.at,
                     .height_m = planned_height_m(point.height_m, species_mix, point.plant_tags, table),
                     .species_mix = species_mix});
  }
  report.account("plants", "tree") = account;
  return trees;
}

const map::PlantTags& tags_of(const map::FeatureView& features, const ground::LandCoverPolygon& surface) {
  static constexpr map::PlantTags kNoTags;
  const auto found = std::ranges::lower_bound(features.areas, surface.id, {}, &map::AreaFeature::id);
  return found != features.areas.end() && found->id == surface.id ? found->plant_tags : kNoTags;
}

// User-defined spawners set the plants of an area, unless its tags name a species.
bool has_spawner(const map::PlantTags& plant_tags) { return is_spawner(species_mix_for(plant_tags, {})); }

// Trees in towns outside of parks and gardens.
bool is_assumed(const WoodRow& row) {
  const map::LandCoverGroup group = map::values_of(row.surface).group;
  return group == map::LandCoverGroup::kTown || group == map::LandCoverGroup::kIndustry;
}

std::vector<Wood> plan_woods(const map::FeatureView& features, std::span<const ground::LandCoverPolygon> surfaces,
                             Assumptions assumed) {
  std::vector<Wood> woods;
  for (const ground::LandCoverPolygon& surface : surfaces)
    for (const WoodRow& row : kWoods)
      if (row.surface == surface.surface && !has_spawner(tags_of(features, surface)) &&
          (has(assumed, Assumption::kYards) || !is_assumed(row)))
        woods.push_back({.surface = surface.id,
                         .species_mix = species_mix_for(tags_of(features, surface), species_mix_of(row.community)),
                         .trees_per_ha = row.trees_per_ha,
                         .height_m = row.height_m});
  return woods;
}

// Orchards and plant nurseries have the tagged species, spaced by its crown width.
Planting planting_on(const ground::LandCoverPolygon& surface, const PlantingRow& row, const map::PlantTags& plant_tags,
                     const map::Heightfield& terrain, const SpeciesTable& table) {
  const SpeciesMix usual = row.species_mix;
  Planting planting{.surface = surface.id,
                    .species_mix = usual,
                    .heading = row_heading(surface, terrain),
                    .row_spacing_m = row.row_spacing_m,
                    .plant_spacing_m = row.plant_spacing_m,
                    .height_m = row.height_m};
  const SpeciesMix tagged = species_mix_for(plant_tags, usual);
  const bool is_tagged = plant_tags.kind != map::PlantKind::kUnknown && tagged != usual;
  if (!is_tagged || (row.surface != LandCoverClass::kOrchard && row.surface != LandCoverClass::kPlantNursery))
    return planting;
  const Species species = single_species(planting.species_mix = tagged);
  planting.height_m = in_eighths(default_height_m(table[species]));
  planting.row_spacing_m = planting.plant_spacing_m =
      std::max(in_eighths(planting.height_m * table[species].crown_share), kLeastPlantSpacing_m);
  return planting;
}

// The plants that a spawner sets on an area: one in each cell of a square grid.
Planting spawned_on(const ground::LandCoverPolygon& surface, SpeciesMix species_mix, const SpeciesTable& table) {
  const Spawner& spawner = table.spawner(species_mix);
  double tallest_m = 0;
  for (const SpawnerShare& each : spawner.species)
    tallest_m = std::max(tallest_m, table[each.species].height_m * spawner.to_scale);
  return {.surface = surface.id,
          .species_mix = species_mix,
          .heading = 0,
          .row_spacing_m = spawner.grid_m,
          .plant_spacing_m = spawner.grid_m,
          .height_m = std::max(in_eighths(tallest_m), 0.125)};
}

std::vector<Planting> plan_plantings(const map::FeatureView& features,
                                     std::span<const ground::LandCoverPolygon> surfaces,
                                     const map::Heightfield& terrain, const SpeciesTable& table) {
  std::vector<Planting> plantings;
  for (const ground::LandCoverPolygon& surface : surfaces) {
    const map::PlantTags& plant_tags = tags_of(features, surface);
    if (has_spawner(plant_tags)) {
      if (map::values_of(surface.surface).group != map::LandCoverGroup::kBuilding)
        plantings.push_back(spawned_on(surface, species_mix_for(plant_tags, {}), table));
      continue;
    }
    for (const PlantingRow& row : kPlantings)
      if (row.surface == surface.surface) plantings.push_back(planting_on(surface, row, plant_tags, terrain, table));
    for (const PlantingRow& row : kCrops)
      if (row.surface == surface.surface && plant_tags.kind != map::PlantKind::kUnknown &&
          species_mix_for(plant_tags, {}) == row.species_mix)
        plantings.push_back(planting_on(surface, row, plant_tags, terrain, table));
  }
  return plantings;
}

// A line offset to the left, with mitred bends.
Polyline offset_left(const Polyline& axis, double left_m) {
  constexpr double kLeastCosine = 0.5;
  Polyline line;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const Vec2 before = unit(axis[std::max<std::size_t>(i, 1)] - axis[std::max<std::size_t>(i, 1) - 1]);
    const Vec2 after = i + 1 < axis.size() ? unit(axis[i + 1] - axis[i]) : before;
    const Vec2 first = i > 0 ? before : after, middle = unit(first + after);
    const double mitre = std::max(dot(middle, after), kLeastCosine);
    const Vec2 p = snapped_to(map::kMapStep_m, axis[i] + left_of(middle) * (left_m / mitre));
    if (line.empty() || line.back() != p) line.push_back(p);
  }
  return line;
}

// Rows on the left have even part numbers, those on the right odd ones.
void add_avenue(const roads::Road& road, const map::Track& track, std::vector<TreeRow>& rows) {
  const map::TreeSides sides = track.trees;
  const SpeciesMix species_mix = species_mix_for({.kind = track.tree_kind}, species_mix_of(PlantCommunity::kTownTrees));
  const std::uint32_t part = 2 * road.id.part;
  const auto add = [&](double left_m, std::uint32_t number) {
    Polyline line = offset_left(road.axis, left_m);
    if (line.size() >= 2)
      rows.push_back({.id = {road.id.osm, part + number}, .axis = std::move(line), .species_mix = species_mix});
  };
  const double drift_m = roads::drift_m(road, length_m(road.axis));
  if (sides != map::TreeSides::kRight) add(roads::left_m(road) + std::max(0.0, drift_m) + kBehindKerb_m, 0);
  if (sides != map::TreeSides::kLeft) add(-roads::right_m(road) + std::min(0.0, drift_m) - kBehindKerb_m, 1);
}

void add_avenues(const map::FeatureView& features, std::span<const roads::Road> roads, std::vector<TreeRow>& rows) {
  for (const roads::Road& road : roads) {
    const auto found = std::ranges::lower_bound(features.tracks, road.id, {}, &map::Track::id);
    if (found != features.tracks.end() && found->id == road.id && found->trees != map::TreeSides::kNone)
      add_avenue(road, *found, rows);
  }
}

std::vector<TreeRow> plan_rows(const map::FeatureView& features, std::span<const roads::Road> roads,
                               const SpeciesTable& table, Report& report) {
  std::vector<TreeRow> rows;
  Account account;
  for (const map::TreeRow& row : features.tree_rows) {
    account.in += report.counts(row.id.osm), account.out += report.counts(row.id.osm);
    const SpeciesMix species_mix = species_mix_for(row.plant_tags, species_mix_of(PlantCommunity::kTownTrees));
    rows.push_back({.id = row.id,
                    .axis = row.axis,
                    .species_mix = species_mix,
                    .height_m = in_eighths(planned_height_m(row.height_m, species_mix, row.plant_tags, table)),
                    .spacing_m = in_eighths(row.spacing_m)});
  }
  report.account("plants", "row") = account;
  add_avenues(features, roads, rows);
  return rows;
}

}  // namespace

Plants plan(const map::FeatureView& features, std::span<const ground::LandCoverPolygon> surfaces,
            std::span<const roads::Road> roads, const map::Heightfield& terrain, Report& report, Assumptions assumed,
            const SpeciesTable& table) {
  assert(std::ranges::is_sorted(features.areas, {}, &map::AreaFeature::id));
  assert(std::ranges::is_sorted(features.tracks, {}, &map::Track::id));
  Plants plants{.trees = plan_trees(features, table, report),
                .woods = plan_woods(features, surfaces, assumed),
                .plantings = plan_plantings(features, surfaces, terrain, table),
                .rows = plan_rows(features, roads, table, report),
                .corridors = {}};
  for (const map::PowerLine& line : features.power_lines)
    plants.corridors.push_back({line.id, line.axis, in_eighths(line.corridor_m)});
  std::ranges::stable_sort(plants.trees, {}, &Tree::id);
  std::ranges::stable_sort(plants.woods, {}, &Wood::surface);
  std::ranges::stable_sort(plants.plantings, {}, &Planting::surface);
  std::ranges::stable_sort(plants.rows, {}, &TreeRow::id);
  return plants;
}

}  // namespace citykiln::plants
