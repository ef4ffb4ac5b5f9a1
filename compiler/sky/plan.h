// Plans the sky: the position of the sun at a place and a time.
#pragma once

#include <string>

#include "compiler/contract/result.h"
#include "compiler/map/plane.h"
#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// Returns the sky at a place and a time.
///
/// @param time  "2026-06-21T15:00" (seconds and a final Z are optional), UTC. "" is 15:00 solar time on midsummer day
///              of the place's hemisphere.
/// Method: low-precision formulas of the Astronomical Almanac, 0.01° between 1950 and 2050; no atmospheric refraction.
/// Error: a time that does not parse.
Result<Sky> plan(map::LonLat place, const std::string& time);

}  // namespace citykiln::sky
