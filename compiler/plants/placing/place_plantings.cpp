#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/plants/placing/placing.h"
#include "compiler/plants/placing/row_heading.h"

namespace citykiln::plants {
namespace {

constexpr int kLeastBarePriority = 50;

// Low plants grow up to a path's edge.
constexpr double kLowClearance_m = 0.25, kLow_m = 2;

// How far a plant stands off its place in the row, as a share of the distance to the next: people plant evenly, grass
// does not.
constexpr double kPlantedOff = 0.1, kWildOff = 0.95;

constexpr double kHeightSpread = 0.15;

// A tile's fields are measured by places this far apart.
constexpr double kProbe_m = 16;

bool is_blade(const Planting& planting) {
  return is_single_species(planting.species_mix) &&
         values_of(single_species(planting.species_mix)).leaves == LeafForm::kBlade;
}

/// The surface of a planting, by id; surfaces are sorted by id.
std::uint32_t surface_of(const ground::LandCoverIndex& map, const Planting& planting) {
  const auto first = std::ranges::lower_bound(map.surfaces, planting.surface, {}, &ground::LandCoverPolygon::id);
  for (auto at = first; at != map.surfaces.end() && at->id == planting.surface; ++at)
    if (map::values_of(at->surface).group != map::LandCoverGroup::kBuilding)
      return static_cast<std::uint32_t>(at - map.surfaces.begin());
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

/// Rows counted from the plane's origin: (along, across) in plants and rows.
struct RowGrid {
  Vec2 along, across;  // one plant on, one row on

  Vec2 at(double plant, double row) const { return along * plant + across * row; }
  double plant(Vec2 p) const { return dot(p, along) / dot(along, along); }
  double row(Vec2 p) const { return dot(p, across) / dot(across, across); }
};

RowGrid grid_of(const Planting& planting) {
  const Vec2 along = row_direction(planting.heading);
  return {along * planting.plant_spacing_m, left_of(along) * planting.row_spacing_m};
}

struct Range {
  std::int64_t first, last;
};

/// The whole numbers that a function has over the corners of a box, and one more on either side.
template <typename Of>
Range range_over(const Box2& box, Of of) {
  double least = of(box.min), most = least;
  for (const Vec2 corner : {Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
    least = std::min(least, of(corner)), most = std::max(most, of(corner));
  return {static_cast<std::int64_t>(std::floor(least)) - 1, static_cast<std::int64_t>(std::floor(most)) + 1};
}

/// Calls visit(place in the grid, its dice) for the plants that may stand in a box; `share` of them.
template <typename Visit>
void for_each_plant(const Planting& planting, const Box2& box, double share, std::uint64_t seed, Visit visit) {
  const RowGrid grid = grid_of(planting);
  const Range plants = range_over(box, [&](Vec2 p) { return grid.plant(p); });
  const Range rows = range_over(box, [&](Vec2 p) { return grid.row(p); });
  const bool is_sown =
      is_single_species(planting.species_mix) && single_species(planting.species_mix) == Species::kGrass;
  const double off = is_sown ? kWildOff : kPlantedOff;
  for (std::int64_t row = rows.first; row <= rows.last; ++row)
    for (std::int64_t plant = plants.first; plant <= plants.last; ++plant) {
      const auto number = static_cast<std::uint64_t>(plant) << 32 ^ (static_cast<std::uint64_t>(row) & 0xffffffffu);
      const Draw draw(seed, stable_id(stable_id(planting.surface), "plant", number), "plant");
      if (draw.unit(kKeptDraw) >= share) continue;
      const double x = static_cast<double>(plant) + off * (draw.unit(kAlongDraw) - 0.5);
      const double y = static_cast<double>(row) + off * (draw.unit(kAcrossDraw) - 0.5);
      if (const Vec2 at = snapped(grid.at(x, y)); is_in_half_open(box, at)) visit(at, draw);
    }
}

void place_planting(PlacedPlants& placed, const Planting& planting, const ObstacleIndex& trees, double share,
                    const PlacingContext& land) {
  const std::uint32_t surface = surface_of(land.surfaces, planting);
  if (surface == ground::kNoLandCover) return;
  const Box2 here = extent_in(land.surfaces.surfaces[surface], land.box);
  if (here.is_empty()) return;
  const double clear_m = planting.height_m <= kLow_m ? kLowClearance_m : kTrunkClearance_m;
  const Vec2 along = row_direction(planting.heading);
  for_each_plant(planting, here, share, land.seed, [&](Vec2 at, const Draw& draw) {
    if (ground::land_cover_at(land.surfaces, at) != surface || is_near_obstacle(trees, at)) return;
    if (clearance_m(land.surfaces, at, kLeastBarePriority, clear_m) < clear_m) return;
    const double height_m = planting.height_m * draw.between(1 - kHeightSpread, 1 + kHeightSpread, kHeightDraw);
    if (!is_single_species(planting.species_mix)) {
      const Species species =
          draw_species(planting.species_mix, habitat_of(land, at), land.seed, draw.unit(kSpeciesDraw));
      return place_plant(placed, land, species, at, height_m, draw, planting.surface.osm);
    }
    const Species species = single_species(planting.species_mix);
    const bool is_aligned = species == Species::kHedge || species == Species::kVine;
    if (is_aligned)
      place_plant_along(placed, land, species, at, height_m, along, draw, planting.surface.osm);
    else
      place_plant(placed, land, species, at, height_m, draw, planting.surface.osm);
  });
}

/// How many plants are asked for in the box, from places on a grid.
double asked_for(std::span<const Planting> plantings, const PlacingContext& land) {
  std::vector<double> per_m2(land.surfaces.surfaces.size());
  for (const Planting& planting : plantings)
    if (const std::uint32_t s = surface_of(land.surfaces, planting); is_blade(planting) && s != ground::kNoLandCover)
      per_m2[s] = 1 / (planting.row_spacing_m * planting.plant_spacing_m);
  double sum = 0;
  for (double y = land.box.min.y + kProbe_m / 2; y < land.box.max.y; y += kProbe_m)
    for (double x = land.box.min.x + kProbe_m / 2; x < land.box.max.x; x += kProbe_m)
      if (const std::uint32_t s = ground::land_cover_at(land.surfaces, {x, y}); s != ground::kNoLandCover)
        sum += per_m2[s] * kProbe_m * kProbe_m;
  return sum;
}

}  // namespace

void place_plantings(PlacedPlants& placed, std::span<const Planting> plantings, std::span<const Obstacle> trees,
                     const PlacingContext& land) {
  const ObstacleIndex obstacles = index_obstacles(trees);
  for (const Planting& planting : plantings)
    if (!is_blade(planting)) place_planting(placed, planting, obstacles, 1, land);
}

PlacedPlants generate_blades(std::span<const Planting> plantings, const PlacingContext& land) {
  constexpr double kKm2_m2 = 1e6;
  PlacedPlants placed;
  const double most = kMostBladesPerKm2 * land.box.width() * land.box.height() / kKm2_m2;
  const double share = std::min(1.0, most / std::max(asked_for(plantings, land), 1.0));
  const ObstacleIndex none = index_obstacles({});
  for (const Planting& planting : plantings)
    if (is_blade(planting)) place_planting(placed, planting, none, share, land);
  return placed;
}

}  // namespace citykiln::plants
