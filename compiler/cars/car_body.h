// The body of a car: its shell with windows, lamps, wheel arches and what is on it.
#pragma once

#include "compiler/cars/car_shape.h"
#include "compiler/cars/facets.h"

namespace citykiln::cars {

/// The levels of a car: wheel arches, wheels, mirrors and all; a shell with wheels; a shell alone.
enum class CarLevel : std::uint8_t { kFull, kPlain, kOutline, kCount };

/// The surfaces that all cars share.
struct CarSurfaces {
  Surface paint, glass, dark, lamp, tail_lamp, plate, rim, load;
};

/// Returns the surfaces of a car with this paint.
CarSurfaces car_surfaces(materials::Tint paint);

/// Adds the shell of a car, which looks along -y, its middle at x = y = 0. O(triangles).
void add_body(const CarShape& shape, CarLevel level, const CarSurfaces& surfaces, Facets& facets);

/// Adds its four wheels; none at CarLevel::kOutline.
void add_wheels(const CarShape& shape, CarLevel level, const CarSurfaces& surfaces, Facets& facets);

}  // namespace citykiln::cars
