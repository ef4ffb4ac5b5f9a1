// Plans the sky: sun, moon and stars at a place and a time.
#pragma once

#include <optional>

#include "compiler/map/plane/plane.h"
#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// Returns the sky at a place and a time, with the air of a clear day.
///
/// @param time  Empty for 15:00 solar time on midsummer day of the place's hemisphere.
/// Guarantees between 1950 and 2050: the apparent directions are exact within 0.02° for the sun, 0.05° for the moon,
/// and 0.02° for stars without proper motion. Gives equal bits on every CPU.
Sky plan(LonLat place, const std::optional<Moment>& time);

}  // namespace citykiln::sky
