#include "compiler/plants/plan.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"
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
#undef WOOD
};

struct PlantingRow {
  LandCoverClass surface;
  Species species;
  double row_spacing_m, plant_spacing_m, height_m;
};
constexpr PlantingRow kPlantings[] = {
#define PLANTING(surface, species, row_spacing_m, plant_spacing_m, height_m) \
  {LandCoverClass::surface, Species::species, row_spacing_m, plant_spacing_m, height_m},
#include "compiler/plants/planting_defaults.inc"
#undef PLANTING
};

// What fields grow where they tell it.
constexpr PlantingRow kCrops[] = {{LandCoverClass::kFarmland, Species::kWheat, 0.5, 0.375, 0.875},
                                  {LandCoverClass::kFarmland, Species::kMaize, 0.75, 0.375, 2.25},
                                  {LandCoverClass::kFarmland, Species::kGrass, 1, 1, 0.375}};

// Trunks of an avenue stand so far behind the kerb.
constexpr double kBehindKerb_m = 1;

double in_eighths(double v) { return std::floor(v * 8 + 0.5) / 8; }

// As told, else by what else is told; a crown tells as much of trees whose kind nobody knows, taken for the commonest.
double height_m_of(double told_m, SpeciesMix species_mix, const map::PlantTags& plant_tags) {
  if (told_m > 0) return told_m;
  return height_from_tags_m(is_single_species(species_mix) ? single_species(species_mix) : Species::kLime, plant_tags);
}

std::vector<Tree> plan_trees(const map::Features& features, Report& report) {
  std::vector<Tree> trees;
  Account account;
  for (const map::PointFeature& point : features.points) {
    if (point.kind != map::PointKind::kTree) continue;
    ++account.in, ++account.out;
    const SpeciesMix species_mix = species_mix_for(point.plant_tags, species_mix_of(PlantCommunity::kTownTrees));
    trees.push_back({point.id, point.at, height_m_of(point.height_m, species_mix, point.plant_tags), species_mix});
  }
  report.account("plants", "tree") = account;
  return trees;
}

const map::PlantTags& growth_of(const map::Features& features, const ground::LandCoverPolygon& surface) {
  static constexpr map::PlantTags kNothingTold;
  const auto found = std::ranges::lower_bound(features.areas, surface.id, {}, &map::AreaFeature::id);
  return found != features.areas.end() && found->id == surface.id ? found->plant_tags : kNothingTold;
}

std::vector<Wood> plan_woods(const map::Features& features, std::span<const ground::LandCoverPolygon> surfaces) {
  std::vector<Wood> woods;
  for (const ground::LandCoverPolygon& surface : surfaces)
    for (const WoodRow& row : kWoods)
      if (row.surface == surface.surface)
        woods.push_back({surface.id, species_mix_for(growth_of(features, surface), species_mix_of(row.community)),
                         row.trees_per_ha, row.height_m});
  return woods;
}

// Orchards and nurseries grow what they tell, at distances for its crowns.
Planting planting_on(const ground::LandCoverPolygon& surface, const PlantingRow& row, const map::PlantTags& plant_tags,
                     const map::Heightfield& terrain) {
  const SpeciesMix usual = species_mix_of(row.species);
  Planting planting{surface.id,          usual,       row_heading(surface, terrain), row.row_spacing_m,
                    row.plant_spacing_m, row.height_m};
  const SpeciesMix told = species_mix_for(plant_tags, usual);
  const bool is_told = plant_tags.kind != map::PlantKind::kUnknown && told != usual;
  if (!is_told || (row.surface != LandCoverClass::kOrchard && row.surface != LandCoverClass::kPlantNursery))
    return planting;
  const Species species = single_species(planting.species_mix = told);
  planting.height_m = in_eighths(default_height_m(species));
  planting.row_spacing_m = planting.plant_spacing_m =
      std::max(in_eighths(planting.height_m * crown_share(species)), kLeastPlantSpacing_m);
  return planting;
}

std::vector<Planting> plan_plantings(const map::Features& features, std::span<const ground::LandCoverPolygon> surfaces,
                                     const map::Heightfield& terrain) {
  std::vector<Planting> plantings;
  for (const ground::LandCoverPolygon& surface : surfaces) {
    const map::PlantTags& plant_tags = growth_of(features, surface);
    for (const PlantingRow& row : kPlantings)
      if (row.surface == surface.surface) plantings.push_back(planting_on(surface, row, plant_tags, terrain));
    for (const PlantingRow& row : kCrops)
      if (row.surface == surface.surface && plant_tags.kind != map::PlantKind::kUnknown &&
          species_mix_for(plant_tags, {}) == species_mix_of(row.species))
        plantings.push_back(planting_on(surface, row, plant_tags, terrain));
  }
  return plantings;
}

// The line so far to the left of another, with its bends mitred.
Polyline beside(const Polyline& axis, double left_m) {
  constexpr double kLeastCosine = 0.5;
  Polyline line;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const Vec2 before = unit(axis[std::max<std::size_t>(i, 1)] - axis[std::max<std::size_t>(i, 1) - 1]);
    const Vec2 after = i + 1 < axis.size() ? unit(axis[i + 1] - axis[i]) : before;
    const Vec2 first = i > 0 ? before : after, middle = unit(first + after);
    const double mitre = std::max(dot(middle, after), kLeastCosine);
    const Vec2 p = snapped(axis[i] + left_of(middle) * (left_m / mitre));
    if (line.empty() || line.back() != p) line.push_back(p);
  }
  return line;
}

// Left ones are named apart from those on the right.
void add_avenue(const roads::Road& road, map::TreeSides sides, std::vector<TreeRow>& rows) {
  const std::uint32_t part = 2 * road.id.part;
  const auto add = [&](double left_m, std::uint32_t number) {
    Polyline line = beside(road.axis, left_m);
    if (line.size() >= 2)
      rows.push_back({{road.id.osm, part + number}, std::move(line), species_mix_of(PlantCommunity::kTownTrees), 0, 0});
  };
  if (sides != map::TreeSides::kRight) add(roads::left_m(road) + kBehindKerb_m, 0);
  if (sides != map::TreeSides::kLeft) add(-roads::right_m(road) - kBehindKerb_m, 1);
}

void add_avenues(const map::Features& features, std::span<const roads::Road> roads, std::vector<TreeRow>& rows) {
  for (const roads::Road& road : roads) {
    const auto found = std::ranges::lower_bound(features.tracks, ObjectId{road.id.osm, 0}, {}, &map::Track::id);
    if (found == features.tracks.end() || found->id.osm != road.id.osm || found->trees == map::TreeSides::kNone)
      continue;
    add_avenue(road, found->trees, rows);
  }
}

std::vector<TreeRow> plan_rows(const map::Features& features, std::span<const roads::Road> roads, Report& report) {
  std::vector<TreeRow> rows;
  Account account;
  for (const map::TreeRow& row : features.tree_rows) {
    ++account.in, ++account.out;
    const SpeciesMix species_mix = species_mix_for(row.plant_tags, species_mix_of(PlantCommunity::kTownTrees));
    rows.push_back({row.id, row.axis, species_mix, in_eighths(height_m_of(row.height_m, species_mix, row.plant_tags)),
                    in_eighths(row.spacing_m)});
  }
  report.account("plants", "row") = account;
  add_avenues(features, roads, rows);
  return rows;
}

}  // namespace

Plants plan(const map::Features& features, std::span<const ground::LandCoverPolygon> surfaces,
            std::span<const roads::Road> roads, const map::Heightfield& terrain, Report& report) {
  Plants plants{plan_trees(features, report),
                plan_woods(features, surfaces),
                plan_plantings(features, surfaces, terrain),
                plan_rows(features, roads, report),
                {}};
  for (const map::PowerLine& line : features.power_lines)
    plants.corridors.push_back({line.id, line.axis, in_eighths(line.corridor_m)});
  std::ranges::stable_sort(plants.trees, {}, &Tree::id);
  std::ranges::stable_sort(plants.woods, {}, &Wood::surface);
  std::ranges::stable_sort(plants.plantings, {}, &Planting::surface);
  std::ranges::stable_sort(plants.rows, {}, &TreeRow::id);
  return plants;
}

}  // namespace citykiln::plants
