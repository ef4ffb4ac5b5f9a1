#include "compiler/bake/place_furniture.h"

#include <algorithm>

#include "compiler/furniture/street_furniture.h"
#include "compiler/furniture/street_trees.h"
#include "compiler/things/generate.h"

namespace citykiln::bake {

furniture::StreetRecipes street_recipes_of(const scene::Chunk& chunk, std::span<const plants::Tree> trees,
                                           std::span<const props::StreetLamp> lamps,
                                           const ground::LandCoverIndex& land_cover) {
  return {.roads = chunk.roads,
          .junctions = chunk.junctions,
          .yards = chunk.yards,
          .buildings = chunk.buildings,
          .things = chunk.things,
          .trees = trees,
          .tree_rows = chunk.tree_rows,
          .lamps = lamps,
          .land_cover = land_cover};
}

std::vector<plants::Tree> trees_with_street_trees(const scene::Header& header, const scene::Chunk& chunk,
                                                  const Lamps& lamps, const ground::LandCoverIndex& land_cover,
                                                  const Box2& box) {
  std::vector<plants::Tree> trees = chunk.trees;
  if (!header.has_street_furniture) return trees;
  const furniture::StreetRecipes recipes = street_recipes_of(chunk, chunk.trees, lamps.standing, land_cover);
  std::ranges::copy(furniture::street_trees(recipes, header.seed, header.tile_m, box), std::back_inserter(trees));
  return trees;
}

std::vector<PlacedThing> place_furniture(const scene::Header& header, const scene::Chunk& chunk,
                                         std::span<const plants::Tree> trees, const Lamps& lamps,
                                         const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded,
                                         const Box2& box) {
  if (!header.has_street_furniture) return {};
  const furniture::StreetRecipes recipes = street_recipes_of(chunk, trees, lamps.standing, land_cover);
  std::vector<PlacedThing> placed;
  for (const things::Thing& piece : furniture::street_furniture(recipes, header.seed, header.tile_m, box)) {
    const bool has_rules = std::ranges::any_of(
        header.things, [&](const buildings::RuleText& text) { return text.name == piece.form.kind; });
    if (has_rules) placed.push_back({.form = piece.form, .placement = place(piece, graded), .is_parked = true});
  }
  return placed;
}

}  // namespace citykiln::bake
