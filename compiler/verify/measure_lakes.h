// Level faces of lakes and other standing water in a baked tile.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/scene/scene.h"
#include "compiler/verify/ground_index.h"

namespace citykiln::verify {

struct Lakes {
  std::uint64_t waters = 0;     ///< Standing waters with a face in the tile.
  std::uint64_t not_level = 0;  ///< Waters with a corner off their level by more than rounding.
  double largest_m = 0;         ///< Largest deviation.
  OsmId worst{};
  Vec2 at{};  ///< Of the largest deviation.
};

/// The counts added, and the larger of the deviations.
Lakes combined(const Lakes& a, const Lakes& b);

/// Measures every corner of every upward-facing face of waters with a level. Parts of a water that run are left out
/// (water_levels.h). O(faces log waters).
Lakes measure_lakes(const scene::Chunk& chunk, const GroundIndex& ground);

}  // namespace citykiln::verify
