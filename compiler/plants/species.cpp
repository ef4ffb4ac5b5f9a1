#include "compiler/plants/species.h"

namespace citykiln::plants {

const SpeciesValues& values_of(Species species) {
  static constexpr SpeciesValues kValues[] = {
#define SPECIES(name, file, leaves, height_m, tallest_m) {file, LeafForm::leaves, height_m, tallest_m},
#include "compiler/plants/species.inc"
#undef SPECIES
  };
  return kValues[static_cast<std::size_t>(species)];
}

}  // namespace citykiln::plants
