// Plans the sky: sun, moon and stars at a place and a time.
#pragma once

#include <string>

#include "compiler/contract/result.h"
#include "compiler/map/plane.h"
#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// Returns the sky at a place and a time, with the air of a clear day.
///
/// @param time  As parse_time() reads it. "" is 15:00 solar time on midsummer day of the place's hemisphere.
/// Guarantees between 1950 and 2050: the sun within 0.02°, the moon within 0.05°, stars without proper motion within
/// 0.02° of where they are seen. The same bits on every CPU. Error: a time that does not parse.
Result<Sky> plan(map::LonLat place, const std::string& time);

}  // namespace citykiln::sky
