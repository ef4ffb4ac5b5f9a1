// The table of user-defined species, species.txt: what files of plants do not say. The format is explained in
// user_species.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// A row of species.txt. Values that are not given follow from the plant, or from the species that it is like.
struct SpeciesRow {
  std::string name;
  std::vector<std::string> names{};  ///< Words of tags, as map::lower_words() returns them.
  std::string like{};                ///< A shipped species; "" for none.
  std::optional<double> height_m{}, tallest_m{}, crown_share{};
  std::optional<LeafForm> leaf_form{};
  std::optional<Thousandths> leaf{}, bark{}, young_leaf{}, turned_leaf{};
  std::string months{};  ///< 12 letters; "" for those of the species that it is like.
  std::string place{};   ///< File and line.
};

/// True for names of species: small letters, digits and _, at most 40, a letter first.
bool is_species_name(std::string_view text);

/// Reads a table: a name and its values, key=value, in a line; "#" begins a comment. Errors, with file and line: a name
/// that is used twice, an unknown key, a value that cannot be read.
Result<std::vector<SpeciesRow>> read_species_rows(std::string_view text, const std::string& file);

/// Returns a row as text that read_species_rows() reads. Leaves out its names, and values that are not given.
std::string to_text(const SpeciesRow& row);

}  // namespace citykiln::plants
