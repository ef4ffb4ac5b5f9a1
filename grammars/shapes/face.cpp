#include "grammars/shapes/face.h"

#include <algorithm>
#include <cmath>

namespace citykiln::grammars {
namespace {

Ring3 reversed_ring(const Ring3& ring) { return {ring.rbegin(), ring.rend()}; }

// Corners are rounded, so a short edge may be at a large angle to the plane.
Vec3 in_plane(Vec3 edge, Vec3 normal) {
  const double off_m = dot(edge, normal);
  return std::abs(off_m) <= kOnPlane_m ? edge : edge - normal * off_m;
}

Vec3 snapped_to_vertex(Vec3 p, const Face& like, double snap_m) {
  Vec3 nearest = p;
  double best_m = snap_m;
  each_vertex(like, [&](const Vec3& v) {
    const double d_m = length(v - p);
    if (d_m > best_m) return;
    best_m = d_m;
    nearest = v;
  });
  return nearest;
}

Ring3 lifted_ring(std::span<const Vec2> ring, const FaceFrame& frame, const Face& like, double snap_m) {
  Ring3 made;
  made.reserve(ring.size());
  for (const Vec2 p : ring) made.push_back(snapped_to_vertex(frame.to_space(p), like, snap_m));
  return made;
}

}  // namespace

Vec3 double_area_vector_m2(std::span<const Vec3> ring) {
  // the cross product of the diagonals
  if (ring.size() == 4) return cross(ring[2] - ring[0], ring[3] - ring[1]);
  Vec3 sum;
  for (std::size_t i = 2; i < ring.size(); ++i) sum = sum + cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  return sum;
}

Vec3 double_area_vector_m2(const Face& face) {
  Vec3 sum = double_area_vector_m2(face.outer);
  for (const Ring3& hole : face.holes) sum = sum + double_area_vector_m2(hole);
  return sum;
}

Vec3 normal_of(const Face& face) { return unit(double_area_vector_m2(face.outer)); }
double area_m2(const Face& face) { return length(double_area_vector_m2(face)) / 2; }

double bend_m(const Face& face) {
  const Vec3 normal = normal_of(face);
  double low_m = HUGE_VAL, high_m = -HUGE_VAL;
  each_vertex(face, [&](Vec3 p) {
    low_m = std::min(low_m, dot(normal, p));
    high_m = std::max(high_m, dot(normal, p));
  });
  return high_m - low_m > kOnPlane_m ? high_m - low_m : 0;
}

Face reversed(const Face& face) {
  Face made = face;
  made.outer = reversed_ring(face.outer);
  for (Ring3& hole : made.holes) hole = reversed_ring(hole);
  // edge i of the ring is edge n - 2 - i of the reversed ring
  if (!face.street_edges.empty())
    std::rotate_copy(face.street_edges.rbegin(), face.street_edges.rbegin() + 1, face.street_edges.rend(),
                     made.street_edges.begin());
  return made;
}

std::size_t vertex_count(std::span<const Face> faces) {
  std::size_t count = 0;
  for (const Face& face : faces) {
    count += face.outer.size();
    for (const Ring3& hole : face.holes) count += hole.size();
  }
  return count;
}

FaceFrame frame_of(const Face& face) {
  FaceFrame frame;
  frame.origin = face.outer.empty() ? Vec3{} : face.outer.front();
  frame.z = normal_of(face);
  frame.x = {1, 0, 0};
  for (std::size_t i = 0; i < face.outer.size(); ++i) {
    const Vec3 edge = in_plane(face.outer[(i + 1) % face.outer.size()] - face.outer[i], frame.z);
    if (length(edge) <= kOnPlane_m) continue;
    frame.x = unit(edge);
    break;
  }
  frame.y = cross(frame.z, frame.x);
  return frame;
}

Polygon flat(const Face& face, const FaceFrame& frame) {
  Polygon polygon;
  for (const Vec3 p : face.outer) polygon.outer.push_back(frame.to_plane(p));
  for (const Ring3& hole : face.holes) {
    Ring& ring = polygon.holes.emplace_back();
    for (const Vec3 p : hole) ring.push_back(frame.to_plane(p));
  }
  return polygon;
}

Face lifted(const Polygon& polygon, const FaceFrame& frame, const Face& like, double snap_m) {
  Face face;
  face.outer = lifted_ring(polygon.outer, frame, like, snap_m);
  for (const Ring& hole : polygon.holes) face.holes.push_back(lifted_ring(hole, frame, like, snap_m));
  return face;
}

}  // namespace citykiln::grammars
