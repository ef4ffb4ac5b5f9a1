#include "compiler/plants/habit.h"
#include "compiler/plants/standing.h"

namespace citykiln::plants {
namespace {

constexpr double kSpread = 0.25;

struct Grown {
  Species species;
  double height_m;
};

Grown grown(const Tree& tree, const Land& land, const Draw& draw) {
  const Habitat habitat = habitat_of(land, tree.at);
  const Species species = draw_species(tree.stock, habitat, land.seed, draw.unit(kSpeciesDice));
  if (tree.height_m > 0) return {species, tree.height_m};
  const double spread = draw.between(1 - kSpread, 1 + kSpread, kHeightDice);
  return {species, usual_height_m(species) * vigour(habitat) * spread};
}

}  // namespace

std::vector<Obstacle> place_trees(Placed& placed, std::span<const Tree> trees, const Land& land, Report& report) {
  std::vector<Obstacle> standing;
  Account account;
  for (const Tree& tree : trees) {
    const bool is_here = stands_in(land.box, tree.at);
    if (is_here) ++account.in;
    if (!land.surfaces.box.contains(tree.at) || is_covered(land.surfaces, tree.at)) {
      if (is_here) report.drop(account, Code::kTreeOnRoad, tree.id.osm);
      continue;
    }
    const Draw draw(land.seed, stable_id(tree.id), "tree");
    const auto [species, height_m] = grown(tree, land, draw);
    standing.push_back({tree.at, reach_of_crown_m(species, height_m)});
    if (!is_here) continue;
    ++account.out;
    stand(placed, land, species, tree.at, height_m, draw, tree.id.osm);
  }
  report.account("bake", "tree") = account;
  return standing;
}

}  // namespace citykiln::plants
