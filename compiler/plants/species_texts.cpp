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

std::vector<SpeciesText> species_for(std::span<const Tree> trees, std::span<const Wood> woods) {
  std::set<std::string_view> names;
  for (const Tree& tree : trees) names.insert(values_of(tree.species).file);
  std::vector<SpeciesText> texts;
  for (const SpeciesText& text : shipped_species())
    if (!woods.empty() || names.contains(text.name)) texts.push_back(text);
  return texts;
}

}  // namespace citykiln::plants
