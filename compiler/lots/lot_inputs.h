// The inputs of lots, yards and houses beside the features of the map.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/lots/plan_lots.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::lots {

/// The inputs of lots, yards and houses besides the features. Refers to its parts, which must outlive it.
struct LotInputs {
  std::span<const roads::Road> roads;          ///< Planned roads with their pavements.
  std::span<const roads::Junction> junctions;  ///< The junctions of these roads.
  std::span<const OsmId> private_ways;         ///< Sorted (map/ways/private_ways.h).
  const ClimateAt& climate_at;
  std::uint64_t seed = 0;
  int threads = 0;  ///< 0: all processors.
};

}  // namespace citykiln::lots
