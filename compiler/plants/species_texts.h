// The files that plants grow from.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace citykiln::plants {

/// A species' file as it is written into the manifest.
struct SpeciesText {
  std::string name;  ///< SpeciesValues::file.
  std::string text;
  bool operator==(const SpeciesText&) const = default;
};

/// What citykiln ships: lsystems/species, built in. Sorted by name.
std::span<const SpeciesText> shipped_species();

struct Plants;

/// The files of what may stand in a scene, sorted by name: of all that its stocks may be drawn as, of bushes at the
/// rims of woods, and of hedges along lines where there are any.
std::vector<SpeciesText> species_for(const Plants& plants, bool has_hedges);

}  // namespace citykiln::plants
