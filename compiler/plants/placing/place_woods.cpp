#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/plants/placing/placing.h"
#include "compiler/plants/placing/wood_map.h"

namespace citykiln::plants {
namespace {

// So near to where a forest ends it is bushes, mostly.
constexpr double kRim_m = 4.5, kRimBushes = 0.55;

/// The least spacing of the woods in the buckets that a block touches.
double least_spacing_m(const WoodMap& woods, const Box2& block) {
  const ground::LandCoverIndex& map = woods.land.surfaces;
  const auto bucket = [&](double offset_m, int count) {
    return static_cast<int>(std::clamp(std::floor(offset_m / map.bucket_m), 0.0, count - 1.0));
  };
  const int first = bucket(block.min.x - map.corner.x, map.columns),
            last = bucket(block.max.x - map.corner.x, map.columns);
  double least_m = 0;
  for (int row = bucket(block.min.y - map.corner.y, map.rows); row <= bucket(block.max.y - map.corner.y, map.rows);
       ++row)
    for (std::uint32_t e = map.bucket_starts[static_cast<std::size_t>(row) * map.columns + first];
         e < map.bucket_starts[static_cast<std::size_t>(row) * map.columns + last + 1]; ++e) {
      const std::uint32_t wood = woods.of_surface[map.entries[e].surface];
      if (wood == ground::kNoLandCover) continue;
      const double spacing_m = woods.densities[wood].spacing_m;
      least_m = least_m > 0 ? std::min(least_m, spacing_m) : spacing_m;
    }
  return least_m;
}

bool is_forest(const WoodMap& woods, Vec2 p) {
  const std::uint32_t surface = ground::land_cover_at(woods.land.surfaces, p);
  if (surface == ground::kNoLandCover) return false;
  return map::values_of(woods.land.surfaces.surfaces[surface].surface).group == map::LandCoverGroup::kForest;
}

bool is_at_rim(const WoodMap& woods, Vec2 p) {
  constexpr std::array<Vec2, 4> kAbout = {{{kRim_m, 0}, {0, kRim_m}, {-kRim_m, 0}, {0, -kRim_m}}};
  return is_forest(woods, p) && std::ranges::any_of(kAbout, [&](Vec2 offset) { return !is_forest(woods, p + offset); });
}

void grow(PlacedPlants& placed, const WoodMap& woods, const Sample& site) {
  const Wood& wood = woods.woods[site.density.owner];
  const PlacingContext& land = woods.land;
  const Draw draw(land.seed, site.id, "tree");
  const Habitat habitat = habitat_of(land, site.at);
  Species species = draw_species(wood.species_mix, habitat, land.seed, draw.unit(kSpeciesDraw));
  if (draw.unit(kKeptDraw) < kRimBushes && is_at_rim(woods, site.at)) species = Species::kBush;
  place_plant(placed, land, species, site.at, height_in_wood_m(wood, species, habitat, draw), draw, wood.surface.osm);
}

}  // namespace

void place_woods(PlacedPlants& placed, std::span<const Wood> woods, std::span<const Obstacle> trees,
                 std::span<const PowerLineCorridor> corridors, const PlacingContext& land) {
  if (woods.empty()) return;
  const WoodMap map = map_woods(woods, land);
  const std::vector<Sample> samples = blue_noise(
      land.seed, land.box, [&](const Box2& block) { return least_spacing_m(map, block); },
      [&](Vec2 p) { return density_at(map, p); });
  const ObstacleIndex obstacles = index_obstacles(trees);
  const CorridorIndex kept_free = index_corridors(corridors, land.box);
  for (const Sample& site : samples)
    if (!is_near_obstacle(obstacles, site.at) && !is_in_corridor(kept_free, site.at)) grow(placed, map, site);
}

}  // namespace citykiln::plants
