#include "compiler/plants/species_texts.h"

#include <set>

#include "compiler/plants/plan.h"

namespace citykiln::plants {

std::span<const SpeciesText> shipped_species() {
  static const std::vector<SpeciesText> texts = {
#include "compiler/plants/shipped_species_generated.h"
  };
  return texts;
}

std::vector<SpeciesText> species_for(const Plants& plants, bool has_hedges) {
  std::set<std::string_view> names;
  const auto add = [&](const auto& recipes) {
    for (const auto& recipe : recipes)
      for (const Species species : all_of(recipe.stock)) names.insert(values_of(species).file);
  };
  add(plants.trees), add(plants.woods), add(plants.plantings), add(plants.rows);
  if (!plants.woods.empty()) names.insert(values_of(Species::kBush).file);
  if (has_hedges) names.insert(values_of(Species::kHedge).file);
  std::vector<SpeciesText> texts;
  for (const SpeciesText& text : shipped_species())
    if (names.contains(text.name)) texts.push_back(text);
  return texts;
}

}  // namespace citykiln::plants
