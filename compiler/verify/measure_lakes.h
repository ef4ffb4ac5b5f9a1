// Whether standing water is level in a baked tile.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/scene/scene.h"
#include "compiler/verify/ground_index.h"

namespace citykiln::verify {

struct Lakes {
  std::uint64_t waters = 0;     ///< NonGroundObjects waters with a face in the tile.
  std::uint64_t not_level = 0;  ///< Of these, with a corner of a face off the water's level by more than rounding.
  double largest_m = 0;         ///< How far off at most.
  OsmId worst{};
};

/// Of both, counted together.
Lakes combined(const Lakes& a, const Lakes& b);

/// Every corner of every upward face of a water with a level. O(faces log waters).
Lakes measure_lakes(const scene::Chunk& chunk, const GroundIndex& ground);

}  // namespace citykiln::verify
