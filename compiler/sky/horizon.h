// From the equator to the horizon of a place, and refraction.
#pragma once

#include "compiler/map/plane.h"

namespace citykiln::sky {

/// The direction {east, north, up} of a direction in the frame of the equator of date.
Vec3 at_horizon(Vec3 equatorial, map::LonLat place, double sidereal_deg);

/// The place on the ellipsoid, in equatorial radii, in the frame of the equator of date.
Vec3 place_radii(map::LonLat place, double sidereal_deg);

/// A direction {east, north, up} lifted by refraction, for 10 °C and 1010 hPa.
///
/// Method: Saemundsson 1986, within 0.001° of Bennett 1982 above the horizon; below -1° it falls linearly to 0 at the
/// nadir. The same bits on every CPU.
Vec3 refracted(Vec3 direction);

}  // namespace citykiln::sky
