// Finds bridges that are areas of the map and have no deck: a bridge whose road lies on an area has no slab of its own.
#pragma once

#include <cstdint>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// Bridges of a scene that areas carry.
struct BridgesOnAreas {
  std::uint64_t tests = 0;    ///< Number of these bridges,
  std::uint64_t missing = 0;  ///< and of those without a plate.
  Vec2 at;                    ///< The first of these,
  OsmId first{};              ///< and its element.
};

/// Tests each bridge on an area: one without a slab of its own (DeckForm), or an axis that an area has because no way
/// of the map runs over it. A plate must lie below half of its axis in the extent, or for an axis of an area the area's
/// plate anywhere. O(bridges · plates near).
BridgesOnAreas measure_decks(const scene::Scene& scene);

}  // namespace citykiln::verify
