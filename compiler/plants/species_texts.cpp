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

namespace {

// The species that a scene may draw.
std::set<Species> drawn_species(const Plants& plants, bool has_hedges, const SpeciesTable& table) {
  std::set<Species> drawn;
  const auto add_all = [&](const auto& recipes) {
    for (const auto& recipe : recipes)
      for (const Species species : species_in(table, recipe.species_mix)) drawn.insert(species);
  };
  add_all(plants.trees), add_all(plants.woods), add_all(plants.plantings), add_all(plants.rows);
  // woods have bushes at their edges
  if (!plants.woods.empty())
    for (const Species species : species_in(species_mix_of(PlantCommunity::kWoodEdge))) drawn.insert(species);
  // grass turns to straw in dry climates
  if (drawn.contains(Species::kGrass)) drawn.insert(Species::kStraw);
  if (has_hedges) drawn.insert(Species::kHedge);
  return drawn;
}

bool is_table(const SpeciesText& text) { return text.name == kUserSpeciesName || text.name == kSpawnersName; }

}  // namespace

std::vector<SpeciesText> species_texts_for(const Plants& plants, bool has_hedges, std::span<const SpeciesText> own,
                                           const SpeciesTable& table) {
  std::set<std::string_view> names;
  for (const Species species : drawn_species(plants, has_hedges, table)) names.insert(table[species].file);
  std::vector<SpeciesText> texts;
  for (const SpeciesText& text : own)
    if (is_table(text) || names.contains(species_of(text))) texts.push_back(text);
  for (const SpeciesText& text : shipped_species())
    if (names.contains(text.name) && std::ranges::find(own, std::string_view(text.name), species_of) == own.end())
      texts.push_back(text);
  std::ranges::sort(texts, {}, &SpeciesText::name);
  return texts;
}

}  // namespace citykiln::plants
