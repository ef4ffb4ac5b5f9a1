// Measures the gaps between buildings and the ground: the height of the lower ends of walls above the ground at the
// buildings' corners.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/ground/ground_index.h"

namespace citykiln::verify {

/// The least limit of gaps that callers pass as allowed_m, and the largest break in a chain of wall edges, in metres.
inline constexpr double kAllowedGap_m = 0.05;

/// The largest gap below one building, and the corner where it is.
struct GapBelow {
  OsmId building;
  double gap_m = 0;
  Vec2 corner;
};

/// The gaps below several buildings.
struct Footing {
  std::uint64_t corners = 0;  ///< Number of corners measured.
  /// From the ground up to the wall; negative if all walls extend into the ground, -1e9 if nothing was measured.
  double largest_gap_m = -1e9;
  OsmId worst{};                   ///< The building with that gap.
  std::vector<GapBelow> floating;  ///< Buildings with a gap over the limit.
};

/// Combines two measurements: adds counts, joins lists and keeps the larger gap.
Footing combined(const Footing& a, const Footing& b);

/// Functions that return the height of the highest ground within a distance in plan of a corner, and the height of the
/// lower end of a building's wall at a corner; empty if unknown.
using GroundHeightAt = std::function<std::optional<double>(Vec2 corner, double within_m)>;
using WallBaseAt = std::function<std::optional<double>(const buildings::Building& building, Vec2 corner)>;

/// Measures the corners, inside the box, of all buildings that stand on the ground. A gap over the limit counts only if
/// there is no higher ground within allowed_m of the corner either: where the ground steps, as at retaining walls, a
/// level moves the step sideways by up to its error, but not downwards. O(corners).
///
/// @param allowed_m  The limit of gaps, metres.
Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const GroundHeightAt& ground,
                        const WallBaseAt& wall);

/// Measures a baked tile by its triangles. The wall at a corner is the chain of vertical edges that begins at the
/// floor. Corners in openings for ways, and corners without an edge at this tolerance, are skipped.
Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const bake::BakedTile& tile,
                        const GroundIndex& ground);

}  // namespace citykiln::verify
