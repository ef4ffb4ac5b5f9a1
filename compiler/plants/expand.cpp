#include "compiler/plants/expand.h"

#include "compiler/plants/placing/standing.h"

namespace citykiln::plants {

Placed expand(const Recipes& recipes, const Land& land, Report& report) {
  Placed placed;
  const std::vector<Obstacle> single = place_trees(placed, recipes.trees, land, report);
  const std::vector<Obstacle> trees = place_rows(placed, recipes.rows, single, land);
  place_woods(placed, recipes.woods, trees, recipes.lanes, land);
  place_plantings(placed, recipes.plantings, trees, land);
  return placed;
}

}  // namespace citykiln::plants
