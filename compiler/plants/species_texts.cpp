#include "compiler/plants/species_texts.h"

#include <algorithm>
#include <set>

namespace citykiln::plants {

std::span<const SpeciesText> shipped_species() {
  static const std::vector<SpeciesText> texts = {
#include "compiler/plants/shipped_species_generated.h"
  };
  return texts;
}

std::vector<SpeciesText> species_texts_for(const Plants& plants, bool has_hedges) {
  std::set<Species> drawn;
  const auto add_all = [&](const auto& recipes) {
    for (const auto& recipe : recipes)
      for (const Species species : species_in(recipe.species_mix)) drawn.insert(species);
  };
  add_all(plants.trees), add_all(plants.woods), add_all(plants.plantings), add_all(plants.rows);
  // woods have bushes at their edges
  if (!plants.woods.empty())
    for (const Species species : species_in(species_mix_of(PlantCommunity::kWoodEdge))) drawn.insert(species);
  // grass turns to straw in dry climates
  if (drawn.contains(Species::kGrass)) drawn.insert(Species::kStraw);
  if (has_hedges) drawn.insert(Species::kHedge);
  std::vector<SpeciesText> texts;
  for (const SpeciesText& text : shipped_species())
    if (std::ranges::any_of(drawn, [&](Species species) { return values_of(species).file == text.name; }))
      texts.push_back(text);
  return texts;
}

}  // namespace citykiln::plants
