// Parking places off the street: painted bays, drives of yards, and mapped parking spaces.
#pragma once

#include <span>
#include <vector>

#include "compiler/cars/place.h"
#include "compiler/lots/recipe.h"
#include "compiler/pitches/recipe.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// Returns the places between the lines of painted bays (PitchKind::kBaysOfRows and kBaysOfRow), on any paved ground;
/// none of other pitches. O(1).
std::vector<Place> places_in_bays(const pitches::Pitch& pitch, map::CountryGroup country);

/// Returns the place on each drive of a yard that is long enough, in its middle. O(strips).
std::vector<Place> places_on_drives(const lots::Yard& yard);

/// Returns a mapped parking space (a thing of the role map::ThingRole::kCar) as a place.
Place place_of_space(const things::Thing& space, map::CountryGroup country);

}  // namespace citykiln::cars
