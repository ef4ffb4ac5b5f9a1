// Gaps between buildings and the ground: the lower ends of walls against the ground at the building's corners.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/ground_index.h"

namespace citykiln::verify {

/// The largest gap that counts as none.
inline constexpr double kAllowedGap_m = 0.05;

/// The largest gap below one building.
struct GapBelow {
  OsmId building;
  double gap_m = 0;
  Vec2 corner;
};

struct Footing {
  std::uint64_t corners = 0;       ///< Number of corners measured.
  double largest_gap_m = -1e9;     ///< From the ground up to the wall; negative if all walls reach into the ground.
  OsmId worst{};                   ///< The building with that gap.
  std::vector<GapBelow> floating;  ///< Buildings with a gap over the limit.
};

/// The counts added, the lists joined, and the larger of the gaps.
Footing combined(const Footing& a, const Footing& b);

/// The height of the ground, and of the lower end of a building's wall, at a corner. Empty if unknown.
using GroundHeightAt = std::function<std::optional<double>(Vec2 corner)>;
using WallBaseAt = std::function<std::optional<double>(const buildings::Building& building, Vec2 corner)>;

/// Measures the corners inside the box of all buildings that stand on the ground. O(corners).
Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const GroundHeightAt& ground,
                        const WallBaseAt& wall);

/// Measures a baked tile by its triangles: the wall at a corner is the chain of vertical edges that begins at the
/// floor. Corners at which the tolerance left no edge are skipped.
Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const bake::BakedTile& tile,
                        const GroundIndex& ground);

}  // namespace citykiln::verify
