// The body under a roof, and measures of triangle meshes: closed, manifold, volume, distance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "grammars/roofs/roof.h"

namespace citykiln::roofs {

/// Returns roof, walls down to bottom_m and floor as one closed 2-manifold, oriented outward, without duplicate
/// vertices.
/// @param bottom_m  < 0, and below the soffits if the body must not touch itself.
inline Mesh closed_body(const Roof& roof, double bottom_m) {
  constexpr std::uint32_t kNone = ~0u;
  Mesh body{roof.positions, {}, roof.triangles};
  std::vector<std::uint32_t> below(roof.positions.size(), kNone);
  for (const Triangle& t : roof.floor)
    for (const std::uint32_t v : t)
      if (below[v] == kNone) {
        below[v] = static_cast<std::uint32_t>(body.positions.size());
        body.positions.push_back(at_height(in_plan(roof.positions[v]), bottom_m));
      }
  for (const Triangle& t : roof.floor) body.triangles.push_back({below[t[0]], below[t[2]], below[t[1]]});
  for (const auto& ring : roof.eaves)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      body.triangles.push_back({below[ring[j]], below[ring[i]], ring[i]});
      body.triangles.push_back({below[ring[j]], ring[i], ring[j]});
    }
  return body;
}

/// True if every edge occurs once in each direction and no triangle repeats a vertex.
inline bool is_closed(const Mesh& body) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : body.triangles)
    for (int i = 0; i < 3; ++i) {
      if (t[i] == t[(i + 1) % 3] || t[i] >= body.positions.size()) return false;
      if (++edges[{t[i], t[(i + 1) % 3]}] > 1) return false;
    }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.first.second, e.first.first}) == 1;
  });
}

/// True if the triangles around every vertex are one fan.
inline bool is_manifold_at_vertices(const Mesh& body) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> around(body.positions.size());
  for (const Triangle& t : body.triangles)
    for (int i = 0; i < 3; ++i) around[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
  for (const auto& fan : around) {
    if (fan.empty()) continue;
    std::size_t steps = 0;
    std::uint32_t at = fan.begin()->first;
    do {
      const auto next = fan.find(at);
      if (next == fan.end()) return false;
      at = next->second;
    } while (++steps <= fan.size() && at != fan.begin()->first);
    if (steps != fan.size()) return false;
  }
  return true;
}

/// The volume in cubic metres; positive if triangles are oriented outward.
inline double volume_m3(const Mesh& body) {
  if (body.positions.empty()) return 0;
  const Vec3 o = body.positions.front();
  double six = 0;
  for (const Triangle& t : body.triangles)
    six += dot(body.positions[t[0]] - o, cross(body.positions[t[1]] - o, body.positions[t[2]] - o));
  return six / 6;
}

/// True if no triangle is degenerate.
inline bool has_area_everywhere(const Mesh& body) {
  return std::all_of(body.triangles.begin(), body.triangles.end(), [&](const Triangle& t) {
    const Vec3 a = body.positions[t[0]];
    return length(cross(body.positions[t[1]] - a, body.positions[t[2]] - a)) > 0;
  });
}

inline double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double t = dot(along, along) > 0 ? dot(p - a, along) / dot(along, along) : 0;
  return length(p - (a + along * std::clamp(t, 0.0, 1.0)));
}

inline double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 normal = unit(cross(b - a, c - a));
  const Vec3 foot = p - normal * dot(p - a, normal);
  const bool is_inside = dot(cross(b - a, foot - a), normal) >= 0 && dot(cross(c - b, foot - b), normal) >= 0 &&
                         dot(cross(a - c, foot - c), normal) >= 0;
  if (is_inside) return std::abs(dot(p - a, normal));
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// The largest distance between one body's corners, midpoints of edges and centroids of triangles, and the other body.
inline double distance_m(const Mesh& from, const Mesh& to) {
  double farthest_m = 0;
  for (const Triangle& t : from.triangles) {
    const Vec3 a = from.positions[t[0]], b = from.positions[t[1]], c = from.positions[t[2]];
    for (const Vec3 p : {a, (a + b) * 0.5, (a + b + c) * (1 / 3.0)}) {
      double nearest_m = 1e9;
      for (std::size_t i = 0; i < to.triangles.size() && nearest_m > farthest_m; ++i) {
        const Triangle& u = to.triangles[i];
        nearest_m =
            std::min(nearest_m, distance_to_triangle(p, to.positions[u[0]], to.positions[u[1]], to.positions[u[2]]));
      }
      farthest_m = std::max(farthest_m, nearest_m);
    }
  }
  return farthest_m;
}

}  // namespace citykiln::roofs
