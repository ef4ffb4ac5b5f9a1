// Measures whether the heights of roads and watercourses in the recipes are consistent: grade limits, equal heights at
// common vertices, and water that does not rise.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// Lengths of roads, and of their parts that are too steep.
struct Grades {
  double length_m = 0;  ///< The length of graded roads on the ground, and of bridges and tunnels of the same classes.
  double over_m = 0;    ///< The part of it that exceeds the class's grade limit by more than the rounding of heights.
};

/// Measures the roads inside the chunk's tile. A road across a border counts on each side with its length there. A
/// bridge or tunnel counts in full. O(n).
Grades measure_grades(const scene::Header& header, const scene::Chunk& chunk);

/// Height differences where lines meet.
struct Jumps {
  /// Places with the vertices of several lines: ground roads, and ends of bridges and tunnels. A vertex of one road
  /// that two chunks hold counts too.
  std::uint64_t places = 0;
  double largest_m = 0;
  Vec2 at;
};

/// Measures height differences at common vertices of all chunks: between ground roads, and where bridges or tunnels end
/// at a road or at each other. Lines without a profile, and classes that have none, are skipped. O(n log n).
Jumps measure_jumps(const scene::Scene& scene);

/// Two ways on the ground that cross without a common node, at different heights.
struct CrossingStep {
  OsmId first, second;  ///< first < second.
  double step_m = 0;    ///< The largest difference of the pair.
  Vec2 at;
};

/// Measures pairs of ground roads and rails whose heights differ by more than ground::kSmallStep_m where their axes
/// cross. The ground has one height there, so that one of the ways has a ledge. Ways without a profile lie on the
/// ground and are skipped. The largest steps come first. O(n log n) in segments.
std::vector<CrossingStep> measure_crossing_steps(const scene::Scene& scene);

/// Numbers of watercourses, and of watercourses that flow uphill.
struct Rises {
  std::uint64_t streams = 0, rising = 0;
  double largest_m = 0;
};

/// Finds watercourses that rise along their profile, or from one watercourse to the next at a common vertex. O(n log
/// n).
Rises measure_rises(const scene::Chunk& chunk);

}  // namespace citykiln::verify
