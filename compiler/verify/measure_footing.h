// Whether buildings stand on the ground: the lower ends of their walls against the ground under their corners.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/ground_index.h"

namespace citykiln::verify {

/// A gap under a corner that is no larger is none.
inline constexpr double kAllowedGap_m = 0.05;

struct Footing {
  std::uint64_t corners = 0;    ///< Looked at.
  std::uint64_t floating = 0;   ///< Buildings with a larger gap than allowed under any corner.
  double largest_gap_m = -1e9;  ///< From the ground up to the wall; negative where all reach into it.
  OsmId worst{};
};

/// Of both, counted together.
Footing combined(const Footing& a, const Footing& b);

/// How high the ground lies, and how low a building's walls reach, under a corner of it; none where that is unknown.
using GroundHeightAt = std::function<std::optional<double>(Vec2 corner)>;
using WallBaseAt = std::function<std::optional<double>(const buildings::Building& building, Vec2 corner)>;

/// The corners in the box of all buildings that stand on the ground. O(corners).
Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const GroundHeightAt& ground,
                        const WallBaseAt& wall);

/// The same of a baked tile's own triangles: at a corner stands what its upright edges there reach, one below the
/// other, down from the floor or above. Where the tolerance has left no edge at a corner nothing is known of it.
Footing measure_footing(const scene::Chunk& chunk, const Box2& box, double allowed_m, const bake::BakedTile& tile,
                        const GroundIndex& ground);

}  // namespace citykiln::verify
