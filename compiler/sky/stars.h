// The brightest stars as they are seen from a place.
#pragma once

#include <vector>

#include "compiler/sky/recipe.h"
#include "compiler/sky/spectrum.h"

namespace citykiln::sky {

/// A point of light.
struct Star {
  Vec3 direction;   ///< Unit; lifted by refraction.
  Rgb illuminance;  ///< Illuminance outside of the atmosphere, lx; linear sRGB.
};

/// Returns the apparent direction of a star {east, north, up}: its position in the frame of J2000.0, rotated to the
/// place and time of the sky, and lifted by refraction. Gives equal bits on every CPU.
Vec3 star_direction(const Sky& sky, double right_ascension_deg, double declination_deg);

/// Returns the stars of bright_stars.inc that are above the horizon, brightest first.
///
/// Method: magnitude 0 is 2.54e-6 lx (Allen, "Astrophysical Quantities"). The colour of a star is that of a black body
/// with the temperature for its colour index B - V (Ballesteros 2012).
std::vector<Star> stars_of(const Sky& sky);

}  // namespace citykiln::sky
