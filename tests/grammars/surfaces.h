// Triangles of derivations, and distances between them at random points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "compiler/geometry/triangles/triangulate.h"
#include "grammars/derivation/derive.h"

namespace citykiln::grammars {

struct Triangle3 {
  Vec3 a, b, c;
};

inline std::vector<Triangle3> triangles_of(const Derivation& derivation) {
  std::vector<Triangle3> made;
  for (const Terminal& terminal : derivation.terminals) {
    for (const Face& face : terminal.faces) {
      const FaceFrame frame = frame_of(face);
      const PlaneTriangles flat_ones = triangulate(flat(face, frame));
      // unprojected corners: faces are planar up to rounding
      std::vector<Vec3> points;
      each_vertex(face, [&](Vec3 p) { points.push_back(p); });
      for (std::size_t i = points.size(); i < flat_ones.points.size(); ++i)
        points.push_back(frame.to_space(flat_ones.points[i]));
      for (const Triangle& t : flat_ones.triangles) made.push_back({points[t[0]], points[t[1]], points[t[2]]});
    }
  }
  return made;
}

inline double distance_m(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double t = dot(ab, ab) > 0 ? std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0) : 0;
  return length(p - (a + ab * t));
}

/// The distance to the nearest edge, or to the plane if the point is over the triangle. Accurate for slivers.
inline double distance_m(Vec3 p, const Triangle3& t) {
  const double to_edge_m = std::min({distance_m(p, t.a, t.b), distance_m(p, t.b, t.c), distance_m(p, t.c, t.a)});
  const Vec3 normal = unit(cross(t.b - t.a, t.c - t.a));
  const auto is_left_of = [&](Vec3 a, Vec3 b) { return dot(normal, cross(b - a, p - a)) >= 0; };
  const bool is_over = is_left_of(t.a, t.b) && is_left_of(t.b, t.c) && is_left_of(t.c, t.a);
  return is_over && length(normal) > 0.5 ? std::min(to_edge_m, std::abs(dot(normal, p - t.a))) : to_edge_m;
}

inline double distance_m(Vec3 p, const std::vector<Triangle3>& surface) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Triangle3& t : surface) nearest_m = std::min(nearest_m, distance_m(p, t));
  return nearest_m;
}

/// Returns a point of the triangle from three numbers. About every second one is on its border, where distances are
/// largest.
inline Vec3 point_on(const Triangle3& t, std::uint32_t first, std::uint32_t second, std::uint32_t border) {
  double u = first / 4294967296.0, v = second / 4294967296.0;
  if (u + v > 1) u = 1 - u, v = 1 - v;
  if (border % 4 == 0) u = 0;
  if (border / 4 % 4 == 0) v = 0;
  return t.a + (t.b - t.a) * u + (t.c - t.a) * v;
}

/// The largest distance between sampled points of one surface and the other surface.
/// @param chance  Returns 32 random bits a call.
template <typename Chance>
double sampled_m(const std::vector<Triangle3>& from, const std::vector<Triangle3>& to, int points, Chance chance) {
  double farthest_m = 0;
  for (int i = 0; i < points; ++i) {
    const Triangle3& on = from[chance() % from.size()];
    const std::uint32_t first = chance(), second = chance(), border = chance();
    farthest_m = std::max(farthest_m, distance_m(point_on(on, first, second, border), to));
  }
  return farthest_m;
}

}  // namespace citykiln::grammars
