// A text of a species, as the manifest stores it.
#pragma once

#include <string>
#include <string_view>

namespace citykiln::plants {

/// The file of a species. Manifests with user-defined plants also have the texts kUserSpeciesName and kSpawnersName.
struct SpeciesText {
  /// SpeciesValues::file, the name of a file in our notation without ".lsys"; other files with their extension.
  std::string name;
  std::string text;
  bool operator==(const SpeciesText&) const = default;
};

/// The names of the tables of species and of spawners.
inline constexpr std::string_view kUserSpeciesName = "species.txt", kSpawnersName = "spawners.txt";

/// Returns the name of the species: the text's name without extension.
inline std::string_view species_of(const SpeciesText& text) {
  return std::string_view(text.name).substr(0, text.name.find('.'));
}

}  // namespace citykiln::plants
