#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/plants/placing/placing.h"
#include "compiler/plants/placing/wood_map.h"

namespace citykiln::plants {
namespace {

// Width of a forest's edge, and share of bushes in it.
constexpr double kEdge_m = 4.5, kEdgeBushes = 0.55;

// The least spacing of the woods in the grid cells that a block touches; 0 without woods.
double least_spacing_m(const WoodMap& woods, const Box2& block) {
  const ground::LandCoverIndex& map = woods.context.surfaces;
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
  const std::uint32_t surface = ground::land_cover_at(woods.context.surfaces, p);
  if (surface == ground::kNoLandCover) return false;
  return map::values_of(woods.context.surfaces.surfaces[surface].surface).group == map::LandCoverGroup::kForest;
}

bool is_at_edge(const WoodMap& woods, Vec2 p) {
  constexpr std::array<Vec2, 4> kAbout = {{{kEdge_m, 0}, {0, kEdge_m}, {-kEdge_m, 0}, {0, -kEdge_m}}};
  return is_forest(woods, p) && std::ranges::any_of(kAbout, [&](Vec2 offset) { return !is_forest(woods, p + offset); });
}

void place_tree(PlacedPlants& placed, const WoodMap& woods, const Sample& sample) {
  const Wood& wood = woods.woods[sample.density.owner];
  const PlacingContext& context = woods.context;
  const RandomSequence draw(context.seed, sample.id, "tree");
  const Habitat habitat = habitat_of(context, sample.at);
  Species species = draw_species(wood.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw));
  if (draw.unit(kKeptDraw) < kEdgeBushes && is_at_edge(woods, sample.at)) species = Species::kBush;
  place_plant(placed, context, species, sample.at, height_in_wood_m(wood, species, habitat, draw), draw,
              wood.surface.osm);
}

}  // namespace

void place_woods(PlacedPlants& placed, std::span<const Wood> woods, std::span<const Obstacle> trees,
                 std::span<const PowerLineCorridor> corridors, const PlacingContext& context) {
  if (woods.empty()) return;
  const WoodMap map = map_woods(woods, context);
  const std::vector<Sample> samples = blue_noise(
      context.seed, context.box, [&](const Box2& block) { return least_spacing_m(map, block); },
      [&](Vec2 p) { return density_at(map, p); });
  const ObstacleIndex obstacles = index_obstacles(trees);
  const CorridorIndex kept_free = index_corridors(corridors, context.box);
  for (const Sample& sample : samples)
    if (!is_near_obstacle(obstacles, sample.at) && !is_in_corridor(kept_free, sample.at))
      place_tree(placed, map, sample);
}

}  // namespace citykiln::plants
