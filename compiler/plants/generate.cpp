#include "compiler/plants/generate.h"

#include <cassert>

#include "compiler/plants/placing/placing_steps.h"

namespace citykiln::plants {

GeneratedPlants generate(const PlantRecipes& recipes, const PlacingContext& context, Report& report) {
  assert(!context.box.is_empty());
  GeneratedPlants generated;
  PlacedPlants& placed = generated.placed;
  const std::vector<TreeClearance> single = place_trees(placed, recipes.trees, context, report);
  const std::vector<TreeClearance> trees = place_rows(placed, recipes.rows, single, context);
  place_woods(placed, recipes.woods, trees, recipes.corridors, context);
  place_plantings(placed, recipes.plantings, trees, context);
  for (const TreeClearance& tree : trees) generated.trunks.push_back(tree.at);
  return generated;
}

PlacedPlants generate_blades(std::span<const Planting> plantings, const PlacingContext& context) {
  assert(!context.box.is_empty());
  PlacedPlants placed;
  place_blades(placed, plantings, kMostBladesPerKm2, context);
  return placed;
}

}  // namespace citykiln::plants
