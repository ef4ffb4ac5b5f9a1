// A roof builder for tests that does not round to a grid.
#pragma once

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "grammars/derivation/roof_builder.h"

namespace citykiln::grammars {
namespace plain_roofs {

inline bool is_convex(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0) return false;
  return n >= 3;
}

inline Vec2 centroid_of(const Ring& ring) {
  Vec2 sum;
  double area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const double twice = cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    sum = sum + (ring[0] + ring[i - 1] + ring[i]) * (twice / 3);
    area += twice;
  }
  return area > 0 ? sum * (1 / area) : ring[0];
}

inline double height_over_m(const Ring& ring, std::size_t edge, Vec2 p) {
  const Vec2 a = ring[edge], along = unit(ring[(edge + 1) % ring.size()] - a);
  return cross(along, p - a);
}

inline Face base_of(const Ring& ring) {
  Face base;
  for (std::size_t i = ring.size(); i-- > 0;) base.outer.push_back(at_height(ring[i], 0));
  base.tag = FaceTag::kBottom;
  return base;
}

inline double slope_of(const RoofRequest& request) { return tangent(std::clamp(request.angle_deg, 0.0, 89.0)); }

inline std::vector<Face> pyramid(const RoofRequest& request) {
  const Ring& ring = request.footprint.outer;
  const Vec2 middle = centroid_of(ring);
  double run_m = HUGE_VAL;
  for (std::size_t i = 0; i < ring.size(); ++i) run_m = std::min(run_m, height_over_m(ring, i, middle));
  const double height_m = request.by_height ? request.height_m : slope_of(request) * run_m;
  std::vector<Face> faces = {base_of(ring)};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Face& face = faces.emplace_back();
    face.outer = {at_height(ring[i], 0), at_height(ring[(i + 1) % ring.size()], 0), at_height(middle, height_m)};
    face.tag = FaceTag::kTop;
  }
  return faces;
}

inline Face shed_side(Vec2 a, Vec2 b, double rise_a_m, double rise_b_m) {
  Face side;
  side.outer = {at_height(a, 0), at_height(b, 0)};
  if (rise_b_m > kOnPlane_m) side.outer.push_back(at_height(b, rise_b_m));
  if (rise_a_m > kOnPlane_m) side.outer.push_back(at_height(a, rise_a_m));
  side.tag = FaceTag::kSide;
  return side;
}

inline std::vector<Face> shed(const RoofRequest& request) {
  const Ring& ring = request.footprint.outer;
  const std::size_t edge = request.edge % ring.size();
  double run_m = 0;
  for (const Vec2 p : ring) run_m = std::max(run_m, height_over_m(ring, edge, p));
  const double slope = request.by_height ? request.height_m / std::max(run_m, kOnPlane_m) : slope_of(request);
  std::vector<Face> faces = {base_of(ring), Face{}};
  faces[1].tag = FaceTag::kTop;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double rise_a_m = slope * height_over_m(ring, edge, a), rise_b_m = slope * height_over_m(ring, edge, b);
    faces[1].outer.push_back(at_height(a, std::max(rise_a_m, 0.0)));
    Face side = shed_side(a, b, rise_a_m, rise_b_m);
    if (side.outer.size() > 2) faces.push_back(std::move(side));
  }
  return faces;
}

}  // namespace plain_roofs

/// Returns pyramids and sheds on convex footprints without holes or overhang, in double precision. The apex of a
/// pyramid is over the centroid; its height is the one that the angle gives over the nearest edge.
inline std::optional<std::vector<Face>> plain_roof(const RoofRequest& request) {
  using namespace plain_roofs;
  const bool simple = request.footprint.holes.empty() && request.overhang_m == 0 && is_convex(request.footprint.outer);
  const bool rises = request.by_height ? request.height_m > 0 : request.angle_deg > 0;
  if (!simple || !rises) return std::nullopt;
  if (request.kind == RoofKind::kPyramid) return pyramid(request);
  if (request.kind == RoofKind::kShed) return shed(request);
  return std::nullopt;
}

}  // namespace citykiln::grammars
