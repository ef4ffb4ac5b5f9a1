// The files of species: all shipped ones, and those that a scene needs.
#pragma once

#include <span>
#include <vector>

#include "compiler/plants/plan.h"
#include "compiler/plants/species_text.h"

namespace citykiln::plants {

/// Returns the files of lsystems/species, which are compiled into the program. Sorted by name.
std::span<const SpeciesText> shipped_species();

/// Returns the files of all species that a scene may draw, sorted by name.
/// @param has_hedges  The scene has hedges, which are plants of Species::kHedge.
/// @param own    User-defined files, which replace shipped ones of the same species, and their tables
///               (species_folder.h), which are returned too.
/// @param table  The species of `own` and the shipped ones.
std::vector<SpeciesText> species_texts_for(const Plants& plants, bool has_hedges, std::span<const SpeciesText> own = {},
                                           const SpeciesTable& table = shipped_table());

}  // namespace citykiln::plants
