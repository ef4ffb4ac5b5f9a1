// What covers each face of a triangulated arrangement.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/delaunay.h"

namespace citykiln::ground {

inline constexpr std::uint32_t kNoOwner = 0xffffffffu;

/// A face, and how often it is inside of whom.
struct LabelledFace {
  std::uint32_t face = 0;
  std::vector<WindingStep> windings;
};

/// For each face the owner of the lowest rank that it is inside of (a winding above zero), or kNoOwner.
///
/// @param ranks  One an owner, all different; the lowest is on top.
/// Method: walks from the known face over all others, adding the steps of every edge it crosses and taking them back on
/// its way home, so that faces a rounding has made thin are labelled as consistently as wide ones. O(faces · log
/// owners).
std::vector<std::uint32_t> label_faces(const Delaunay& triangulation, const Arrangement& arrangement,
                                       const LabelledFace& known, std::span<const std::uint32_t> ranks);

/// The face with the largest inscribed circle, and that circle's centre (units of 2^-10 m).
struct WidestFace {
  std::uint32_t face = 0;
  double x = 0, y = 0;
};
WidestFace widest_face(const Delaunay& triangulation);

}  // namespace citykiln::ground
