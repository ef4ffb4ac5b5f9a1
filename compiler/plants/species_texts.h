// The files that plants grow from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/plants/recipe.h"

namespace citykiln::plants {

/// A species' file as it is written into the manifest.
struct SpeciesText {
  std::string name;  ///< SpeciesValues::file.
  std::string text;
  bool operator==(const SpeciesText&) const = default;
};

/// What citykiln ships: lsystems/species, built in. Sorted by name.
std::span<const SpeciesText> shipped_species();

/// The files of what may stand in a scene, sorted by name: of the trees' species, and, where there are woods, which
/// draw theirs when they are fired, all.
std::vector<SpeciesText> species_for(std::span<const Tree> trees, std::span<const Wood> woods);

}  // namespace citykiln::plants
