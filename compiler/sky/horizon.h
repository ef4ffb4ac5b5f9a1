// Conversion of equatorial directions to a place's horizon, and refraction.
#pragma once

#include "compiler/map/plane/plane.h"

namespace citykiln::sky {

/// Converts a direction from the frame of the equator of date to {east, north, up} at a place.
Vec3 at_horizon(Vec3 equatorial, LonLat place, double sidereal_deg);

/// Returns the position of a place on the ellipsoid, in equatorial radii, in the frame of the equator of date.
Vec3 place_radii(LonLat place, double sidereal_deg);

/// Returns a direction {east, north, up} lifted by refraction, for 10 °C and 1010 hPa.
///
/// Method: Saemundsson 1986, within 0.001° of Bennett 1982 above the horizon; below -1° it falls linearly to 0 at the
/// nadir. Gives equal bits on every CPU.
Vec3 refracted(Vec3 direction);

}  // namespace citykiln::sky
