// Parking places off the street: painted bays, drives of yards, and mapped parking spaces.
#pragma once

#include <vector>

#include "compiler/cars/place.h"
#include "compiler/lots/recipe.h"
#include "compiler/pitches/recipe.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// Returns the places between the lines of painted bays (PitchKind::kBaysOfRows and kBaysOfRow), 2.5 by 5 m; none of
/// other pitches. has_ground() tests their ground later. O(bays).
std::vector<Place> places_in_bays(const pitches::Pitch& pitch, map::CountryGroup country);

/// Returns the place on each drive of a yard of 4.75 m or more, in its middle: 2 m wide, at most 5 m long. O(strips).
std::vector<Place> places_on_drives(const lots::Yard& yard);

/// Returns the places on a plot that is a car park: a row at its rear and one at its front, 2.5 by 5 m each, none
/// within 3 m of its sides. None on plots of other kinds. O(places).
std::vector<Place> places_on_plot(const lots::Yard& plot);

/// Returns a mapped parking space (a thing of the role map::ThingRole::kCar) as a place of 2 by 5 m, as spaces may be
/// as narrow as a car.
Place place_of_space(const things::Thing& space, map::CountryGroup country);

}  // namespace citykiln::cars
