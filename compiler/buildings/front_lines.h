// Converts the shop fronts of a building to the form that grammar rules read: lines in plan with a kind and a colour,
// lit or not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/buildings/recipe.h"
#include "grammars/derivation/context_query.h"

namespace citykiln::buildings {

/// Returns one line for each of Building::fronts, in the same order, plane metres. The seed, the building and the index
/// of the front select one of the fascia colours of its kind (map::FrontValues::colours).
/// @param night  The time if it is dark; else empty, and no front is lit.
std::vector<grammars::FrontLine> front_lines(const Building& building, const std::optional<WeekTime>& night,
                                             std::uint64_t seed);

}  // namespace citykiln::buildings
