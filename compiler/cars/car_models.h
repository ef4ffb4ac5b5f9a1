// Draws the body and the colour of a car.
#pragma once

#include <cstdint>

#include "compiler/cars/place.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// The least length of a place: that of the second shortest body, which stands where a longer one has no room.
inline constexpr double kLeastPlace_m = 4.1875;

/// Returns the form of the car in a place: one of the 12 bodies and 8 colours of car_models.inc, by their weights for
/// its country. A body that is longer than the place becomes a hatchback. Half of the vans and minibuses are white; the
/// others draw their colour by weight as all cars do. Requires length_m >= kLeastPlace_m.
things::Form form_of_car(const Place& place, std::uint64_t seed);

/// Returns the form of a lorry, whose cab has a colour drawn as that of a car, and that of a bus, which has the colour
/// of all buses of a seed.
things::Form form_of_lorry(const Place& place, std::uint64_t seed);
things::Form form_of_bus(const Place& place, std::uint64_t seed);

}  // namespace citykiln::cars
