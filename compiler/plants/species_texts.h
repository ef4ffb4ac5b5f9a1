// The files that plants grow from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/plants/plan.h"

namespace citykiln::plants {

/// A species' file as it is written into the manifest.
struct SpeciesText {
  std::string name;  ///< SpeciesValues::file.
  std::string text;
  bool operator==(const SpeciesText&) const = default;
};

/// What citykiln ships: lsystems/species, built in. Sorted by name.
std::span<const SpeciesText> shipped_species();

/// The files of all that may be drawn in a scene, sorted by name.
std::vector<SpeciesText> species_texts_for(const Plants& plants, bool has_hedges);

}  // namespace citykiln::plants
