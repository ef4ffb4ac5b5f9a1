// The L-system files of species: all shipped ones, and those that a scene needs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/plants/plan.h"

namespace citykiln::plants {

/// The .lsys file of a species, as stored in the manifest.
struct SpeciesText {
  std::string name;  ///< SpeciesValues::file.
  std::string text;
  bool operator==(const SpeciesText&) const = default;
};

/// Returns the files of lsystems/species, which are compiled into the program. Sorted by name.
std::span<const SpeciesText> shipped_species();

/// Returns the files of all species that a scene may draw, sorted by name.
std::vector<SpeciesText> species_texts_for(const Plants& plants, bool has_hedges);

}  // namespace citykiln::plants
