// Layers of clouds by name, or from a file.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/sky/clouds/recipe.h"

namespace citykiln::sky {

/// Returns the layers of a named sky ("clear", "fair", "broken", "overcast"), at heights over the ground, or the layers
/// of a JSON file:
///
///     {"layers": [{"kind": "cumulus", "cover": 0.4, "base": 1500, "top": 2400, "wind": [5, 2], "seed": 3}]}
///
/// Heights in files are metres above sea level, winds m/s towards east and north. All keys but `kind` are optional.
/// @param ground_m  Mean height of the ground, above sea level. Named skies are placed over it.
/// @param seed      The seed of named skies, and of layers of a file that give none.
/// Errors, each in one line: a file that is missing, malformed or larger than 64 kB; an unknown key; a number out of
/// its limits.
Result<std::vector<CloudLayer>> read_clouds(const std::string& name_or_path, double ground_m, std::uint64_t seed);

}  // namespace citykiln::sky
