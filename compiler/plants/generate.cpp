#include "compiler/plants/generate.h"

#include "compiler/plants/placing/placing.h"

namespace citykiln::plants {

PlacedPlants generate(const PlantRecipes& recipes, const PlacingContext& land, Report& report) {
  PlacedPlants placed;
  const std::vector<Obstacle> single = place_trees(placed, recipes.trees, land, report);
  const std::vector<Obstacle> trees = place_rows(placed, recipes.rows, single, land);
  place_woods(placed, recipes.woods, trees, recipes.corridors, land);
  place_plantings(placed, recipes.plantings, trees, land);
  return placed;
}

}  // namespace citykiln::plants
