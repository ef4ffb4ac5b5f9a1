// Measures whether the faces of lakes and other standing water in a baked tile are level.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/scene/scene.h"
#include "compiler/verify/ground/ground_index.h"

namespace citykiln::verify {

/// The deviations of standing waters from their levels.
struct Lakes {
  std::uint64_t waters = 0;     ///< Standing waters with a face in the tile.
  std::uint64_t not_level = 0;  ///< Waters with a corner that deviates by more than rounding.
  double largest_m = 0;         ///< The largest deviation, in metres.
  OsmId worst{};                ///< The water with the largest deviation.
  Vec2 at{};                    ///< The place of the largest deviation.
};

/// Combines two measurements: adds counts and keeps the larger deviation.
Lakes combined(const Lakes& a, const Lakes& b);

/// Measures every corner of every upward-facing face of waters with a level. Running parts of a water are left out
/// (water_levels.h). O(faces log waters).
Lakes measure_lakes(const scene::Chunk& chunk, const GroundIndex& ground);

}  // namespace citykiln::verify
