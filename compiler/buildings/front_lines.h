// The shop fronts of a building as rules see them: lines in plan with a kind, a colour and lamps.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/buildings/recipe.h"
#include "grammars/derivation/context_query.h"

namespace citykiln::buildings {

/// Returns the fronts of a building, in their order. The colour of a fascia is one of its kind's, by seed and building.
/// @param night  The time, if it is dark; else no front is lit.
std::vector<grammars::FrontLine> front_lines(const Building& building, const std::optional<WeekTime>& night,
                                             std::uint64_t seed);

}  // namespace citykiln::buildings
