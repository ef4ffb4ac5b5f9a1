// Decides at which spots people are at a given hour.
#pragma once

#include "compiler/buildings/lit_windows.h"
#include "compiler/people/recipe.h"
#include "compiler/people/spot.h"

namespace citykiln::people {

/// Returns the share of spots like this one that have people, from 0 to 1: by use, extent and country group
/// (presence.inc). It is continuous in time with a period of one week.
double usual_presence(const Spot& spot, buildings::WeekTime time);

/// True if somebody is at a spot. Each spot has a rank in [0, 1) and is taken while the share is above it.
bool is_somebody_at(const Spot& spot, const PeopleShare& wish, buildings::WeekTime time, std::uint64_t seed);

}  // namespace citykiln::people
