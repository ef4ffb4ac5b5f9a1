// Stage 9: the sun at a place and a time.
#pragma once

#include <string>

#include "compiler/contract/result.h"
#include "compiler/map/plane.h"
#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// @param time  "2026-06-21T15:00" (or with seconds, or a final Z), UTC. "" is 15:00 solar time at midsummer of the
/// place's hemisphere. Sun by the low-precision formulas of the Astronomical Almanac (0.01° between 1950 and 2050).
/// Errors: a time that does not parse.
Result<Sky> plan(map::LonLat place, const std::string& time);

}  // namespace citykiln::sky
