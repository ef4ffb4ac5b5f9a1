// Labels each face of a triangulated arrangement with what covers it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/delaunay.h"

namespace citykiln::ground {

inline constexpr std::uint32_t kNoOwner = 0xffffffffu;

/// A face with known winding numbers.
struct LabelledFace {
  std::uint32_t face = 0;
  std::vector<WindingStep> windings;
};

/// Returns for each face the owner of the lowest rank whose winding number there is above zero, or kNoOwner.
///
/// @param ranks  One per owner, all different; the lowest is on top.
/// Method: depth-first walk from the known face. Crossing an edge adds its winding steps and returning subtracts them,
/// so labels depend on edges alone, and faces that rounding has made thin are labelled as consistently as wide ones.
/// O(faces · log owners).
std::vector<std::uint32_t> label_faces(const Delaunay& triangulation, const Arrangement& arrangement,
                                       const LabelledFace& known, std::span<const std::uint32_t> ranks);

/// The face with the largest inscribed circle, and the circle's centre in units of 2^-10 m.
struct WidestFace {
  std::uint32_t face = 0;
  double x = 0, y = 0;
};
WidestFace widest_face(const Delaunay& triangulation);

}  // namespace citykiln::ground
