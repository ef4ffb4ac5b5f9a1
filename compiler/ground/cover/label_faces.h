// Labels each face of a triangulated arrangement (the edges of all polygons) with its topmost land cover.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/triangles/delaunay.h"

namespace citykiln::ground {

/// The label of a face that no polygon covers. An owner is a polygon, by number.
inline constexpr std::uint32_t kNoOwner = 0xffffffffu;

/// A face, and the winding numbers of all polygons there.
struct LabelledFace {
  std::uint32_t face = 0;
  std::vector<WindingStep> windings;
};

/// Returns the owner of each face: among the polygons whose winding number there is above zero, the one of the lowest
/// rank; kNoOwner if there is none.
///
/// @param known  A face where the walk starts.
/// @param ranks  One per owner, all different; the lowest is on top.
///
/// Method: depth-first walk from the known face. Crossing an edge adds its winding steps and returning subtracts them.
/// So labels depend on edges only, and faces that rounding has made thin get consistent labels, too. O(faces · log
/// owners).
std::vector<std::uint32_t> label_faces(const Delaunay& triangulation, const Arrangement& arrangement,
                                       const LabelledFace& known, std::span<const std::uint32_t> ranks);

/// The face with the largest inscribed circle, and the circle's centre in units of 2^-10 m.
struct WidestFace {
  std::uint32_t face = 0;
  double x = 0, y = 0;
};
WidestFace widest_face(const Delaunay& triangulation);

}  // namespace citykiln::ground
