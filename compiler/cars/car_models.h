// Draws the body and the colour of a car.
#pragma once

#include <cstdint>

#include "compiler/cars/place.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// The size of the largest body, in metres.
inline constexpr double kLongestCar_m = 5.375, kWidestCar_m = 1.9375;

/// Returns the form of the car in a place, by the weights of car_models.inc for its country: one of 8 bodies, which is
/// not longer than the place, in one of 8 colours. Half of the vans are white.
things::Form form_of_car(const Place& place, std::uint64_t seed);

}  // namespace citykiln::cars
