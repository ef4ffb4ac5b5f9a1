// What stands near a shape, or is behind it: answers inside(), overlaps(), touches(), has_entrance() and is_lit().
#pragma once

#include <functional>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

enum class OcclusionQuery : std::uint8_t { kInside, kOverlaps, kTouches, kHasEntrance, kIsLit };

/// Answers queries during a derivation. Has to be a pure function.
using Occlusion = std::function<bool(OcclusionQuery, const Shape&)>;

/// A neighbouring building as a prism.
struct Neighbour {
  Polygon outline;  ///< Plane metres.
  double bottom_m = 0, top_m = 0;
};

/// Answers by prisms, for the vertices of a shape and the midpoints of its edges and faces: kInside if all are in or on
/// one prism, kOverlaps if some but not all are inside a prism, kTouches if some are on the surface of a prism and none
/// inside one. "On" means within 1 cm, the accuracy at which outlines of neighbours agree. O(points of the shape ·
/// points of the outlines).
Occlusion occlusion_by(std::vector<Neighbour> neighbours);

/// Answers kHasEntrance: true if one of the positions is between the start (inclusive) and the end (exclusive) of the
/// scope's x axis and within 1 m of its xy plane. So of adjacent pieces exactly one has the entrance.
Occlusion entrances_at(std::vector<Vec2> positions);

}  // namespace citykiln::grammars
