#include "grammars/derivation/displacement.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "grammars/shapes/small_vector.h"

namespace citykiln::grammars {
namespace {

constexpr double kLeastArea_m2 = 1e-9;

// The largest distance, or at least `enough_m` if one is as large: then the other points are skipped.
template <typename Distance>
double farthest_m(std::span<const Vec3> points, double enough_m, Distance distance_m) {
  double farthest_m = 0;
  for (std::size_t i = 0; i < points.size() && farthest_m < enough_m; ++i)
    farthest_m = std::max(farthest_m, distance_m(points[i]));
  return farthest_m;
}

bool is_convex(std::span<const Vec3> ring, Vec3 normal) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 in = ring[(i + 1) % n] - ring[i], out = ring[(i + 2) % n] - ring[(i + 1) % n];
    if (dot(normal, cross(in, out)) < 0) return false;
  }
  return n >= 3;
}

// Over the ring the distance is the height above its plane, else that to the nearest edge.
double distance_to_convex_m(Vec3 p, std::span<const Vec3> ring, Vec3 normal) {
  double nearest_m = kUnbounded_m;
  bool over = true;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % ring.size()];
    over &= dot(normal, cross(b - a, p - a)) >= 0;
    nearest_m = std::min(nearest_m, distance_to_segment(a, b, p));
  }
  return over ? std::abs(dot(normal, p - ring[0])) : nearest_m;
}

double farthest_from_face_m(std::span<const Vec3> points, std::span<const Vec3> ring, double enough_m) {
  const Vec3 twice_m2 = double_area_vector_m2(ring);
  const Vec3 normal = unit(twice_m2);
  // a face without area has edges only
  if (length(twice_m2) < kLeastArea_m2 || !is_convex(ring, normal)) return kUnbounded_m;
  return farthest_m(points, enough_m, [&](Vec3 p) { return distance_to_convex_m(p, ring, normal); });
}

// A comp() of thousands of faces would otherwise compare millions of pairs.
constexpr std::size_t kNearestSiblings = 256;

// From a vanished surface to the results of its siblings.
double distance_to_siblings_m(std::size_t vanished, std::span<const ChildTrace> children) {
  const std::size_t first = vanished - std::min(vanished, kNearestSiblings);
  const std::size_t end = std::min(children.size(), vanished + kNearestSiblings + 1);
  double best_m = kUnbounded_m;
  for (const ChildTrace& sibling : children.subspan(first, end - first)) {
    // the distance to the result is at least own.to_later_m
    if (sibling.vanished || sibling.own.to_later_m >= best_m) continue;
    const double enough_m = best_m - sibling.own.to_later_m;
    best_m =
        std::min(best_m, farthest_from_ring_m(children[vanished].vertices, sibling.vertices, sibling.filled, enough_m) +
                             sibling.own.to_later_m);
  }
  return best_m;
}

}  // namespace

Displacement affine_displacement(std::span<const Face> from, std::span<const Face> to) {
  assert(from.empty() || vertex_count(from) == vertex_count(to));
  const Ring3 a = vertices_of(from), b = vertices_of(to);
  double farthest_m = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) farthest_m = std::max(farthest_m, length(b[i] - a[i]));
  return {farthest_m, farthest_m};
}

Displacement any_displacement(std::span<const Vec3> from, std::span<const Vec3> to) {
  if (from.empty() || to.empty()) return {kUnbounded_m, kUnbounded_m};
  double farthest_m = 0;
  for (const Vec3 a : from)
    for (const Vec3 b : to) farthest_m = std::max(farthest_m, length(b - a));
  return {farthest_m, farthest_m};
}

Ring3 vertices_of(std::span<const Face> faces) {
  Ring3 vertices;
  vertices.reserve(vertex_count(faces));
  for (const Face& face : faces) each_vertex(face, [&](Vec3 p) { vertices.push_back(p); });
  return vertices;
}

double farthest_from_ring_m(std::span<const Vec3> points, std::span<const Vec3> ring, bool filled, double enough_m) {
  const std::size_t n = ring.size();
  double best_m = filled ? farthest_from_face_m(points, ring, enough_m) : kUnbounded_m;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % n];
    const auto to_edge_m = [&](Vec3 p) { return distance_to_segment(a, b, p); };
    best_m = std::min(best_m, farthest_m(points, std::min(best_m, enough_m), to_edge_m));
  }
  return best_m;
}

NodeTrace combine(std::span<const ChildTrace> children) {
  NodeTrace node;
  SmallVector<double, 8> to_later_of_group_m;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const ChildTrace& child = children[i];
    node.vanished &= child.vanished;
    if (!child.vanished)
      node.moved.to_earlier_m = std::max(node.moved.to_earlier_m, child.before.to_earlier_m + child.own.to_earlier_m);
    const double own_m = child.vanished ? distance_to_siblings_m(i, children) : child.own.to_later_m;
    if (child.group >= to_later_of_group_m.size()) to_later_of_group_m.resize(child.group + 1, -1);
    double& to_later_m = to_later_of_group_m[child.group];
    to_later_m = std::max(to_later_m, child.before.to_later_m + own_m);
  }
  node.moved.to_later_m = kUnbounded_m;
  // numbers without children are no groups
  for (const double to_later_m : to_later_of_group_m)
    if (to_later_m >= 0) node.moved.to_later_m = std::min(node.moved.to_later_m, to_later_m);
  if (node.vanished) node.moved = {};
  return node;
}

}  // namespace citykiln::grammars
