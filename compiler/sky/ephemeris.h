// The positions of sun, moon and stars, seen from the Earth's centre.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::sky {

// Frames: x towards the equinox of date, z towards the north pole of the Earth's axis. Days are UTC since J2000.0. All
// functions use + − × ÷, the square root and floor only, so they give equal bits on every CPU.

/// Returns the direction to the sun, a unit vector. Error: 0.01° from 1950 to 2050.
Vec3 sun_of_date(double days);

/// Returns the position of the moon's middle, in equatorial radii of the Earth. Error of its direction: 0.02° from 1950
/// to 2050.
Vec3 moon_of_date_radii(double days);

/// Converts a direction from the frame of J2000.0 to the frame of date, by precession alone. Nutation and aberration
/// are below 0.01°.
Vec3 precessed(Vec3 j2000, double days);

/// Returns the mean sidereal time at Greenwich in degrees, not reduced to one turn.
double sidereal_deg(double days);

}  // namespace citykiln::sky
