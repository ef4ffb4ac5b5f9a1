// What the recipes of a scene's lines keep: roads their grade limits and each other's heights where they meet, streams
// their fall.
#pragma once

#include <cstdint>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

struct Grades {
  double length_m = 0;  ///< Of graded roads on the ground, and of bridges and tunnels of their classes.
  double over_m = 0;    ///< Of that, steeper than the class's limit by more than the heights' rounding.
};

/// What lies in the chunk's tile; what crosses a border counts on each side as far as it lies there, bridges and
/// tunnels whole. O(n).
Grades measure_grades(const scene::Header& header, const scene::Chunk& chunk);

struct Jumps {
  std::uint64_t places = 0;  ///< Where two roads, or a road and a bridge or tunnel, meet at a vertex.
  double largest_m = 0;
  Vec2 at;
};

/// Over all chunks: roads of the ground at vertices in common, and what leaves the ground where it ends on one, or
/// where two such ends meet. Roads that follow the ground as it is have no heights of their own: left out. O(n log n).
Jumps measure_jumps(const scene::Scene& scene);

struct Rises {
  std::uint64_t streams = 0, rising = 0;
  double largest_m = 0;
};

/// Streams that rise along their profile, or from one to another at a vertex in common. O(n log n).
Rises measure_rises(const scene::Chunk& chunk);

}  // namespace citykiln::verify
