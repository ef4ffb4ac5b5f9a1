// Layers of clouds by name, or from a file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/sky/clouds/recipe.h"

namespace citykiln::sky {

/// A layer of clouds before the scene that it is over is known.
struct CloudRequest {
  CloudLayer layer;
  bool is_above_ground = false;  ///< Its heights are above the mean height of the ground, else above sea level.
  bool adds_seed = false;        ///< The scene's seed is added to the layer's.
  bool operator==(const CloudRequest&) const = default;
};

/// Returns the layers of a named sky ("clear", "fair", "broken", "overcast"), at heights over the ground, or the layers
/// of a JSON file:
///
///     {"layers": [{"kind": "cumulus", "cover": 0.4, "base": 1500, "top": 2400, "wind": [5, 2], "seed": 3}]}
///
/// Heights in files are metres above sea level, winds m/s towards east and north. All keys but `kind` are optional. The
/// scene's seed is that of named skies, and of layers of a file that give none.
/// Errors, each in one line: a file that is missing, malformed or larger than 64 kB; an unknown key; a number out of
/// its limits.
Result<std::vector<CloudRequest>> read_clouds(const std::string& name_or_path);
/// Returns the layers of the name "fair".
std::vector<CloudRequest> fair_clouds();

/// Returns the layers over a scene.
///
/// @param ground_m  Mean height of the ground, above sea level.
/// @param seed      The scene's seed.
std::vector<CloudLayer> requested_clouds(std::span<const CloudRequest> requests, double ground_m, std::uint64_t seed);

}  // namespace citykiln::sky
