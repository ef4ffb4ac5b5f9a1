// Decides which parking places have a car at an hour.
#pragma once

#include "compiler/buildings/lit_windows.h"
#include "compiler/cars/place.h"
#include "compiler/cars/recipe.h"

namespace citykiln::cars {

/// Returns the usual share of places like this one that have a car, from 0 to 1: by use, country group and kind
/// (occupancy.inc). It is continuous in time and has a period of a week.
double usual_share(const Place& place, buildings::WeekTime time);

/// True if a place has a car. Each place has a rank in [0, 1) and is taken while the share is above it, so that in the
/// course of a day cars only come while the share rises, and only leave while it falls.
bool is_taken(const Place& place, const CarShare& cars, buildings::WeekTime time, std::uint64_t seed);

}  // namespace citykiln::cars
