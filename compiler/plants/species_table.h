// All species of a scene: the shipped ones, the user-defined ones, and the spawners, which draw from them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/plants/species_mix.h"
#include "compiler/plants/species_rows.h"
#include "compiler/plants/species_text.h"

namespace citykiln::plants {

/// A species of a spawner, and its share among them.
struct SpawnerShare {
  Species species{};
  double share = 1;
};

/// A row of spawners.txt (map/plants/user_plants.h), with species by number.
struct Spawner {
  std::vector<SpawnerShare> species{};  ///< Not empty.
  double grid_m = 1, probability = 1, jitter = 0, from_scale = 1, to_scale = 1;
};

/// The species by number. Cheap to copy.
class SpeciesTable {
 public:
  /// The shipped species alone.
  SpeciesTable();
  /// The shipped species, those of kUserSpeciesName and the rows of kSpawnersName, if the texts have these. A table
  /// with an error counts as empty.
  explicit SpeciesTable(std::span<const SpeciesText> texts);
  /// The shipped species, and rows: those with the name of a shipped species replace it, the others have numbers from
  /// kFirstUserSpecies on, in their order; at most kMostUserSpecies are used.
  SpeciesTable(std::span<const SpeciesRow> rows, std::string_view spawners_text);

  /// Returns the values of a species; those of kBush for a number without a species.
  const SpeciesValues& operator[](Species species) const;
  /// Returns the species with this name.
  std::optional<Species> named(std::string_view name) const;
  /// Returns the numbers of all species, shipped ones first.
  std::vector<Species> all() const;

  /// Returns the row of a mix; a single kBush for a number without a row.
  /// @param species_mix  is_spawner() holds.
  const Spawner& spawner(SpeciesMix species_mix) const;

 private:
  struct Rows;
  std::shared_ptr<const Rows> rows_;
};

/// Returns the table of the shipped species alone.
const SpeciesTable& shipped_table();

/// Returns the name of a species, a community without k, or the names of a spawner's species joined by +.
std::string name_of(const SpeciesTable& table, SpeciesMix species_mix);

/// Returns all species that may be drawn, sorted.
std::vector<Species> species_in(const SpeciesTable& table, SpeciesMix species_mix);

/// Draws the species of one plant, as draw_species() of species_mix.h does; of spawners by their shares.
Species draw_species(const SpeciesTable& table, SpeciesMix species_mix, const Habitat& habitat, std::uint64_t seed,
                     double uniform);

}  // namespace citykiln::plants
