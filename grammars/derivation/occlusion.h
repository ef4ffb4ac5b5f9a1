// What stands next to a shape: answers for inside(), overlaps() and touches(), and where its doors have to be.
#pragma once

#include <functional>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

enum class OcclusionQuery : std::uint8_t { kInside, kOverlaps, kTouches, kHasEntrance };

/// Called while one derives; has to be a pure function of its arguments.
using Occlusion = std::function<bool(OcclusionQuery, const Shape&)>;

/// A neighbouring building as others see it: a prism.
struct Neighbour {
  Polygon outline;  ///< Plane metres.
  double bottom_m = 0, top_m = 0;
};

/// Answers by prisms. Looks at a shape's vertices, the middles of its edges and of its faces: `inside` if all lie in or
/// on one prism, `overlaps` if some lie within a prism but not all, `touches` if some lie on a prism's surface and none
/// within one. On is within 1 cm, more than maps of neighbours agree to. O(points of the shape times points of the
/// outlines).
Occlusion occlusion_by(std::vector<Neighbour> neighbours);

/// Answers kHasEntrance alone: one of these places lies before the shape: along its scope's x from 0 to before its end,
/// and no farther than a metre out of its plane. Of pieces side by side one has it.
Occlusion entrances_at(std::vector<Vec2> places);

}  // namespace citykiln::grammars
