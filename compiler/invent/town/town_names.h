// Invented names of streets and places.
#pragma once

#include <string>
#include <vector>

#include "compiler/invent/town/streets/street_graph.h"
#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// Returns the name of a place that does not exist, made of syllables: "Welkow", "Harbenau".
std::string place_name(std::uint64_t seed, std::uint64_t ordinal);

/// Gives streets names: stem and ending, or a place that it seems to lead to. A name that another street has is drawn
/// again, at most 12 times.
void name_streets(const TownPlan& plan, StreetGraph& graph);

}  // namespace citykiln::invent
