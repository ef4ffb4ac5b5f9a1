// The L-system files of species: those shipped, and those that a scene needs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/plants/plan.h"

namespace citykiln::plants {

/// A species' .lsys file as stored in the manifest.
struct SpeciesText {
  std::string name;  ///< SpeciesValues::file.
  std::string text;
  bool operator==(const SpeciesText&) const = default;
};

/// The files of lsystems/species, compiled in. Sorted by name.
std::span<const SpeciesText> shipped_species();

/// The files of all species that a scene may draw, sorted by name.
std::vector<SpeciesText> species_texts_for(const Plants& plants, bool has_hedges);

}  // namespace citykiln::plants
