// Decides which parking places have a car at an hour.
#pragma once

#include "compiler/buildings/lit_windows.h"
#include "compiler/cars/place.h"
#include "compiler/cars/recipe.h"

namespace citykiln::cars {

/// Returns the usual share of places like this one that have a car, from 0 to 1: by use, country group and kind
/// (occupancy.inc). It is continuous in time and has a period of a week.
double usual_share(const Place& place, buildings::WeekTime time);

/// True if a place has a car. Each place has a random rank in [0, 1), and has a car while the share is above its rank.
/// So cars only arrive while the share rises, and only leave while it falls.
bool is_taken(const Place& place, const CarShare& cars, buildings::WeekTime time, std::uint64_t seed);

}  // namespace citykiln::cars
