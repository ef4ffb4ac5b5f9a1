// Finds bridges that rest on a mapped area but have no deck: a bridge whose road lies on an area has no slab of its
// own, so it needs the area's plate (structures/plates.h).
#pragma once

#include <cstdint>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The number of bridges that need a plate, and those of them that have none.
struct BridgesOnAreas {
  std::uint64_t tests = 0;    ///< Number of bridges that need a plate.
  std::uint64_t missing = 0;  ///< Number of those without one.
  Vec2 at;                    ///< The first point of the first bridge without one, plane metres.
  OsmId element{};            ///< Its element.
};

/// Tests each bridge of a scene that needs a plate, once, in the tile of its first point:
/// - a bridge without a slab of its own (DeckForm kPlate or kNone);
/// - an axis that map::with_bridge_areas() gave to an area, whether the area carries bridges of the map or not.
///
/// A plate must lie below at least half of its axis within the extent, sampled at most every 2 m. For an axis of an
/// area it is enough that the box of the area's plate touches the axis' box, since an axis may run beside a bent area.
/// O(metres of these bridges · corners of the plates near).
BridgesOnAreas measure_decks(const scene::Scene& scene);

}  // namespace citykiln::verify
