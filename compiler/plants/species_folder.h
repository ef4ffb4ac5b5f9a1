// Reads a folder of user-defined species: files of plants, species.txt and spawners.txt (user_species.md).
//
//   files ──► read, grown once ──► rows with all values ──► SpeciesTable
//                                  texts for the manifest, words and spawners for the map
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/plants/user_plants.h"
#include "compiler/plants/species_table.h"
#include "compiler/plants/species_text.h"

namespace citykiln::plants {

/// User-defined species.
struct UserSpecies {
  /// The files, and the tables kUserSpeciesName, with the sizes of all grown plants, and kSpawnersName. Sorted by name;
  /// empty without a folder. kUserSpeciesName has no words of tags, and other values only where species.txt gives them:
  /// the rest follows from the species that it is like.
  std::vector<SpeciesText> texts{};
  SpeciesTable table{};
  map::UserPlants for_map{};
};

/// Reads the files of a folder. A species has the name of its file; one with the name of a shipped species replaces it.
/// Values that species.txt does not give follow from the grown plant (height, crown) and from the species that it is
/// like.
///
/// @param files   Plants, species.txt and spawners.txt, by their names in the folder.
/// @param folder  The folder's name, for errors.
/// Errors, with file and line where there is one: those of the notations; two files of one species; a plant that is
/// empty, stops at a limit, has more than lsystems::kMostPlantParts parts or is wider than kWidestCrown times its
/// height; those of read_species_rows() and read_spawners(); a row of a species that has no file and is not shipped; a
/// spawner of a species that is not there; more than kMostUserSpecies species that are not shipped. Cost: some 10 ms a
/// file.
Result<UserSpecies> read_species_folder(std::span<const SpeciesText> files, const std::string& folder);

}  // namespace citykiln::plants
