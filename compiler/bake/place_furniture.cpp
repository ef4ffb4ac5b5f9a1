#include "compiler/bake/place_furniture.h"

#include <algorithm>

#include "compiler/furniture/street_furniture.h"
#include "compiler/things/generate.h"

namespace citykiln::bake {

std::vector<PlacedThing> place_furniture(const scene::Header& header, const scene::Chunk& chunk, const Lamps& lamps,
                                         const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded,
                                         const Box2& box) {
  if (!header.has_street_furniture) return {};
  const furniture::StreetRecipes recipes{.roads = chunk.roads,
                                         .junctions = chunk.junctions,
                                         .yards = chunk.yards,
                                         .buildings = chunk.buildings,
                                         .things = chunk.things,
                                         .trees = chunk.trees,
                                         .lamps = lamps.standing,
                                         .land_cover = land_cover};
  std::vector<PlacedThing> placed;
  for (const things::Thing& piece : furniture::street_furniture(recipes, header.seed, header.tile_m, box)) {
    const bool has_rules = std::ranges::any_of(
        header.things, [&](const buildings::RuleText& text) { return text.name == piece.form.kind; });
    if (has_rules) placed.push_back({.form = piece.form, .placement = place(piece, graded), .is_parked = true});
  }
  return placed;
}

}  // namespace citykiln::bake
