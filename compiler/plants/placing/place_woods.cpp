#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/plants/placing/placing_steps.h"
#include "compiler/plants/placing/wood_index.h"

namespace citykiln::plants {
namespace {

// Width of a forest's edge, and share of bushes in it.
constexpr double kEdge_m = 4.5, kEdgeBushes = 0.55;

// The least spacing of the woods in the grid cells that a block touches; 0 without woods.
double least_spacing_m(const WoodIndex& woods, const Box2& block) {
  const ground::LandCoverIndex& land_cover = woods.context.surfaces;
  const auto bucket = [&](double offset_m, int count) {
    return static_cast<int>(std::clamp(std::floor(offset_m / land_cover.bucket_m), 0.0, count - 1.0));
  };
  const int first = bucket(block.min.x - land_cover.corner.x, land_cover.columns),
            last = bucket(block.max.x - land_cover.corner.x, land_cover.columns);
  double least_m = 0;
  for (int row = bucket(block.min.y - land_cover.corner.y, land_cover.rows);
       row <= bucket(block.max.y - land_cover.corner.y, land_cover.rows); ++row)
    for (std::uint32_t e = land_cover.bucket_starts[static_cast<std::size_t>(row) * land_cover.columns + first];
         e < land_cover.bucket_starts[static_cast<std::size_t>(row) * land_cover.columns + last + 1]; ++e) {
      const std::uint32_t wood = woods.of_surface[land_cover.entries[e].polygon];
      if (wood == ground::kNoLandCover) continue;
      const double spacing_m = woods.densities[wood].spacing_m;
      least_m = least_m > 0 ? std::min(least_m, spacing_m) : spacing_m;
    }
  return least_m;
}

bool is_forest(const WoodIndex& woods, Vec2 p) {
  const std::uint32_t surface = ground::land_cover_at(woods.context.surfaces, p);
  if (surface == ground::kNoLandCover) return false;
  return map::values_of(woods.context.surfaces.surfaces[surface].surface).group == map::LandCoverGroup::kForest;
}

bool is_at_edge(const WoodIndex& woods, Vec2 p) {
  constexpr std::array<Vec2, 4> kAbout = {{{kEdge_m, 0}, {0, kEdge_m}, {-kEdge_m, 0}, {0, -kEdge_m}}};
  return is_forest(woods, p) && std::ranges::any_of(kAbout, [&](Vec2 offset) { return !is_forest(woods, p + offset); });
}

void place_tree(PlacedPlants& placed, const WoodIndex& woods, const Sample& sample) {
  const Wood& wood = woods.woods[sample.density.owner];
  const PlacingContext& context = woods.context;
  const RandomSequence draw(context.seed, sample.id, "tree");
  const Habitat habitat = habitat_of(context, sample.at);
  Species species = draw_species(context.species, wood.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw));
  if (draw.unit(kKeptDraw) < kEdgeBushes && is_at_edge(woods, sample.at))
    species = draw_species(context.species, species_mix_of(PlantCommunity::kWoodEdge), habitat, context.seed,
                           draw.unit(kSpeciesDraw));
  place_plant(placed, context, species, sample.at, height_in_wood_m(wood, context.species[species], habitat, draw),
              draw, wood.surface.osm);
}

}  // namespace

void place_woods(PlacedPlants& placed, std::span<const Wood> woods, std::span<const TreeClearance> trees,
                 std::span<const PowerLineCorridor> corridors, const PlacingContext& context) {
  if (woods.empty()) return;
  const WoodIndex wood_index = index_woods(woods, context);
  const std::vector<Sample> samples = blue_noise(
      context.seed, context.box, [&](const Box2& block) { return least_spacing_m(wood_index, block); },
      [&](Vec2 p) { return density_at(wood_index, p); });
  const TreeClearanceIndex clearances = index_tree_clearances(trees);
  const CorridorIndex kept_free = index_corridors(corridors, context.box);
  for (const Sample& sample : samples)
    if (!is_near_tree(clearances, sample.at) && !is_in_corridor(kept_free, sample.at))
      place_tree(placed, wood_index, sample);
}

}  // namespace citykiln::plants
