#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/dry_cover.h"
#include "compiler/map/row_direction.h"
#include "compiler/plants/placing/placing_steps.h"
#include "compiler/plants/placing/row_heading.h"

namespace citykiln::plants {
namespace {

// Clearance of plants up to kLow_m: they grow up to a path's edge.
constexpr double kLowClearance_m = 0.25, kLow_m = 2;

// Jitter of a plant's place as a share of the spacings: planted in rows, or sown.
constexpr double kPlantedJitter = 0.1, kSownJitter = 0.95;

constexpr double kPlantingHeightSpread = 0.15;

// Spacing of the samples that estimate a tile's field areas.
constexpr double kAreaSample_m = 16;

bool is_blade(const Planting& planting, const PlacingContext& context) {
  if (!is_single_species(planting.species_mix) && !is_spawner(planting.species_mix)) return false;
  return std::ranges::all_of(species_in(context.species, planting.species_mix),
                             [&](Species species) { return context.species[species].leaf_form == LeafForm::kBlade; });
}

// The probability that a plant of the grid is there, apart from the limit of blades.
double probability_of(const Planting& planting, const PlacingContext& context) {
  return is_spawner(planting.species_mix) ? context.species.spawner(planting.species_mix).probability : 1;
}

double jitter_of(const Planting& planting, const PlacingContext& context) {
  if (is_spawner(planting.species_mix)) return context.species.spawner(planting.species_mix).jitter;
  const bool is_sown =
      is_single_species(planting.species_mix) && single_species(planting.species_mix) == Species::kGrass;
  return is_sown ? kSownJitter : kPlantedJitter;
}

double height_m_of(const Planting& planting, const PlacingContext& context, Species species,
                   const RandomSequence& draw) {
  if (!is_spawner(planting.species_mix))
    return planting.height_m * draw.between(1 - kPlantingHeightSpread, 1 + kPlantingHeightSpread, kHeightDraw);
  const Spawner& spawner = context.species.spawner(planting.species_mix);
  return std::min(context.species[species].height_m * draw.between(spawner.from_scale, spawner.to_scale, kHeightDraw),
                  kTallestPlant_m);
}

// The land-cover polygon of a planting; `land_cover.surfaces` is sorted by id, and a building may have the id of a
// planting.
std::uint32_t surface_of(const ground::LandCoverIndex& land_cover, const Planting& planting) {
  const auto first = std::ranges::lower_bound(land_cover.surfaces, planting.surface, {}, &ground::LandCoverPolygon::id);
  for (auto at = first; at != land_cover.surfaces.end() && at->id == planting.surface; ++at)
    if (map::values_of(at->surface).group != map::LandCoverGroup::kBuilding)
      return static_cast<std::uint32_t>(at - land_cover.surfaces.begin());
  return ground::kNoLandCover;
}

Box2 common(const Box2& a, const Box2& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

Box2 extent_in(const ground::LandCoverPolygon& surface, const Box2& box) {
  Box2 around;
  for (const Ring& ring : surface.rings)
    for (const Vec2 p : ring) around.grow(p);
  return common(around, box);
}

// Plane coordinates in plants along and rows across, from the plane's origin.
struct RowGrid {
  Vec2 along, across;  // to the next plant and the next row

  Vec2 at(double plant, double row) const { return along * plant + across * row; }
  double plant(Vec2 p) const { return dot(p, along) / dot(along, along); }
  double row(Vec2 p) const { return dot(p, across) / dot(across, across); }
};

RowGrid row_grid_of(const Planting& planting) {
  const Vec2 along = map::row_direction(planting.heading);
  return {along * planting.plant_spacing_m, left_of(along) * planting.row_spacing_m};
}

struct Range {
  std::int64_t first, last;
};

// The integers between the least and largest value of a linear function on a box, and one more on either side.
template <typename Of>
Range range_over(const Box2& box, Of of) {
  double least = of(box.min), most = least;
  for (const Vec2 corner : {Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
    least = std::min(least, of(corner)), most = std::max(most, of(corner));
  return {static_cast<std::int64_t>(std::floor(least)) - 1, static_cast<std::int64_t>(std::floor(most)) + 1};
}

// Calls visit(plane place, draws) for a share of the plants of the grid that are in a box.
template <typename Visit>
void for_each_plant(const Planting& planting, const Box2& box, double share, const PlacingContext& context,
                    Visit visit) {
  const RowGrid grid = row_grid_of(planting);
  const Range plants = range_over(box, [&](Vec2 p) { return grid.plant(p); });
  const Range rows = range_over(box, [&](Vec2 p) { return grid.row(p); });
  const double jitter = jitter_of(planting, context);
  for (std::int64_t row = rows.first; row <= rows.last; ++row)
    for (std::int64_t plant = plants.first; plant <= plants.last; ++plant) {
      const auto number = static_cast<std::uint64_t>(plant) << 32 ^ (static_cast<std::uint64_t>(row) & 0xffffffffu);
      const RandomSequence draw(context.seed, stable_id(stable_id(planting.surface), "plant", number), "plant");
      if (draw.unit(kKeptDraw) >= share) continue;
      const double x = static_cast<double>(plant) + jitter * (draw.unit(kAlongDraw) - 0.5);
      const double y = static_cast<double>(row) + jitter * (draw.unit(kAcrossDraw) - 0.5);
      if (const Vec2 at = snapped(grid.at(x, y)); box.contains_half_open(at)) visit(at, draw);
    }
}

// All plants of an orchard have one species, drawn for the climate and the altitude of each, which change slowly.
Species species_of_planting(const Planting& planting, const PlacingContext& context, Vec2 at,
                            const RandomSequence& of_plant) {
  if (is_spawner(planting.species_mix))
    return draw_species(context.species, planting.species_mix, {}, context.seed, of_plant.unit(kSpeciesDraw));
  if (is_single_species(planting.species_mix)) return single_species(planting.species_mix);
  Habitat habitat = habitat_of(context, at);
  habitat.at = {}, habitat.is_by_water = false, habitat.shade = 0;
  const RandomSequence draw(context.seed, stable_id(planting.surface), "planting");
  return draw_species(context.species, planting.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw));
}

// Grass is straw in a dry season, and does not grow on bare ground.
std::optional<Species> grass_at(const PlacingContext& context, map::LandCoverClass cover, Vec2 at,
                                const RandomSequence& draw) {
  const ground::DryShares dry = ground::dry_shares(cover, climate_mix_at(context.climate, at), context.month);
  if (draw.unit(kSpeciesDraw) >= 1 - dry.bare) return std::nullopt;
  return draw.unit(kDryDraw) < dry.straw ? Species::kStraw : Species::kGrass;
}

void place_planting(PlacedPlants& placed, const Planting& planting, const TreeClearanceIndex& trees, double share,
                    const PlacingContext& context) {
  const std::uint32_t surface = surface_of(context.surfaces, planting);
  if (surface == ground::kNoLandCover) return;
  const Box2 here = extent_in(context.surfaces.surfaces[surface], context.box);
  if (here.is_empty()) return;
  const double clear_m = planting.height_m <= kLow_m ? kLowClearance_m : kTrunkClearance_m;
  const Vec2 along = map::row_direction(planting.heading);
  for_each_plant(planting, here, share * probability_of(planting, context), context,
                 [&](Vec2 at, const RandomSequence& draw) {
                   if (ground::land_cover_at(context.surfaces, at) != surface || is_near_tree(trees, at)) return;
                   if (clearance_m(context.surfaces, at, kLeastObstaclePriority, clear_m) < clear_m) return;
                   const Species species = species_of_planting(planting, context, at, draw);
                   const double height_m = height_m_of(planting, context, species, draw);
                   if (species == Species::kGrass) {
                     const auto grass = grass_at(context, context.surfaces.surfaces[surface].surface, at, draw);
                     if (grass) place_plant(placed, context, *grass, at, height_m, draw, planting.surface.osm);
                   } else if (species == Species::kHedge || species == Species::kVine) {
                     place_plant_along(placed, context, species, at, height_m, along, draw, planting.surface.osm);
                   } else {
                     place_plant(placed, context, species, at, height_m, draw, planting.surface.osm);
                   }
                 });
}

// Number of blades that the plantings ask for in the box, estimated from the land cover at samples.
double blades_in_box(std::span<const Planting> plantings, const PlacingContext& context) {
  std::vector<double> per_m2(context.surfaces.surfaces.size());
  for (const Planting& planting : plantings)
    if (const std::uint32_t s = surface_of(context.surfaces, planting);
        is_blade(planting, context) && s != ground::kNoLandCover)
      per_m2[s] = 1 / (planting.row_spacing_m * planting.plant_spacing_m);
  double sum = 0;
  for (double y = context.box.min.y + kAreaSample_m / 2; y < context.box.max.y; y += kAreaSample_m)
    for (double x = context.box.min.x + kAreaSample_m / 2; x < context.box.max.x; x += kAreaSample_m)
      if (const std::uint32_t s = ground::land_cover_at(context.surfaces, {x, y}); s != ground::kNoLandCover)
        sum += per_m2[s] * kAreaSample_m * kAreaSample_m;
  return sum;
}

}  // namespace

void place_plantings(PlacedPlants& placed, std::span<const Planting> plantings, std::span<const TreeClearance> trees,
                     const PlacingContext& context) {
  const TreeClearanceIndex clearances = index_tree_clearances(trees);
  for (const Planting& planting : plantings)
    if (!is_blade(planting, context)) place_planting(placed, planting, clearances, 1, context);
}

void place_blades(PlacedPlants& placed, std::span<const Planting> plantings, double most_per_km2,
                  const PlacingContext& context) {
  assert(most_per_km2 > 0);
  constexpr double kKm2_m2 = 1e6;
  const double most = most_per_km2 * context.box.width() * context.box.height() / kKm2_m2;
  const double share = std::min(1.0, most / std::max(blades_in_box(plantings, context), 1.0));
  const TreeClearanceIndex none = index_tree_clearances({});
  for (const Planting& planting : plantings)
    if (is_blade(planting, context)) place_planting(placed, planting, none, share, context);
}

}  // namespace citykiln::plants
