// Distances between meshes by samples, independent of the code under test.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "compiler/simplify/triangle_tree.h"
#include "tests/compiler/buildings/nearest_triangle.h"

namespace citykiln::simplify {

inline buildings::NearestTriangle nearest_of(std::span<const Corners> triangles) {
  std::vector<buildings::Corners> all;
  for (const Corners& t : triangles) all.push_back({t.a, t.b, t.c});
  return buildings::NearestTriangle(std::move(all));
}

/// The largest distance between samples of `from`, `steps` along each edge of a triangle, and `to`.
inline double sampled_distance_m(std::span<const Corners> from, std::span<const Corners> to, int steps) {
  const buildings::NearestTriangle nearest = nearest_of(to);
  double farthest_m = 0;
  for (const Corners& t : from)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
        const Vec3 p = t.a * (1 - u - v) + t.b * u + t.c * v;
        farthest_m = std::max(farthest_m, nearest.distance_m(p, farthest_m));
      }
  return farthest_m;
}

/// A random number in [0, 1) for each index.
inline double noise(std::uint64_t i) {
  i = (i + 0x9e3779b97f4a7c15ull) * 0xbf58476d1ce4e5b9ull;
  i = (i ^ i >> 27) * 0x94d049bb133111ebull;
  return static_cast<double>((i ^ i >> 31) >> 11) * 0x1p-53;
}

}  // namespace citykiln::simplify
