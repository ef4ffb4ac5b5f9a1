// Felkel and Obdržálek 1998 for the skeleton; gables as by Laycock and Day 2003: the face of a wing's end is given to
// its neighbours. Theirs moves the face's node, ours cuts the face's triangle, so the rest of the skeleton stays as it
// is.
#include <algorithm>
#include <cmath>

#include "grammars/roofs/base.h"

namespace citykiln::roofs {
namespace {

// Two walls run nearly parallel if they differ by less than 30 degrees: its cosine.
constexpr double kNearlyParallel = 0.866;
// Nodes of the skeleton closer than this are one: CGAL leaves them double where several events meet.
constexpr double kOneNode_m = 1e-6;

Ring without_double_nodes(const Ring& ring) {
  Ring kept;
  for (const Vec2 p : ring)
    if (kept.empty() || distance(kept.back(), p) > kOneNode_m) kept.push_back(p);
  while (kept.size() > 1 && distance(kept.back(), kept.front()) <= kOneNode_m) kept.pop_back();
  return kept;
}

const Ring& ring_of(const Polygon& polygon, std::uint32_t index) {
  return index == 0 ? polygon.outer : polygon.holes[index - 1];
}

// The planes over an edge's neighbours and itself.
struct Wing {
  Facet before, own, after;
};

Facet facet_over(const Ring& ring, std::uint32_t edge, std::uint32_t first_face) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  return {{}, distance_left_of(ring[edge % n], ring[(edge + 1) % n]), 0, first_face + edge % n};
}

Wing wing_at(const Ring& ring, std::uint32_t edge, std::uint32_t first_face) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  return {facet_over(ring, edge + n - 1, first_face), facet_over(ring, edge, first_face),
          facet_over(ring, edge + 1, first_face)};
}

bool is_end(const Wing& wing, const Ring& face) {
  return face.size() == 3 && dot(wing.before.plane.gradient, wing.after.plane.gradient) < -kNearlyParallel;
}

void add(Base& base, Facet facet, Ring ring) {
  if (ring.empty()) return;
  for (const Vec2 p : ring) base.span_m = std::max(base.span_m, facet.plane.at(p));
  facet.ring = std::move(ring);
  base.facets.push_back(std::move(facet));
}

// The neighbours meet over the end; what the end's own plane, raised, leaves lower is a half hip.
void close_end(Base& base, Wing wing, const Ring& face, bool is_half) {
  const Vec2 a = face[0], b = face[1], top = face[2];
  const double after_m = wing.after.plane.at(a), before_m = wing.before.plane.at(b);
  const Vec2 middle = a + (b - a) * (after_m / (after_m + before_m));
  const Ring first = {a, middle, top}, second = {middle, b, top};
  if (!is_half) {
    add(base, wing.before, first);
    return add(base, wing.after, second);
  }
  wing.own.plane.offset += wing.own.plane.at(top) / 2;
  const Plane over_before = combined(1, wing.own.plane, -1, wing.before.plane);
  const Plane over_after = combined(1, wing.own.plane, -1, wing.after.plane);
  add(base, wing.before, clipped(first, over_before));
  add(base, wing.after, clipped(second, over_after));
  add(base, wing.own,
      clipped(clipped(face, combined(-1, over_before, 0, over_before)), combined(-1, over_after, 0, over_after)));
}

}  // namespace

Base hips(const Polygon& polygon, SkeletonKernel kernel, const EndOf& end_of, std::uint32_t first_face) {
  Base base;
  std::vector<std::uint32_t> first_of_ring = {first_face};
  first_of_ring.push_back(first_face + static_cast<std::uint32_t>(polygon.outer.size()));
  for (const Ring& hole : polygon.holes)
    first_of_ring.push_back(first_of_ring.back() + static_cast<std::uint32_t>(hole.size()));
  for (const SkeletonFace& face : straight_skeleton(polygon, kernel)) {
    const Wing wing = wing_at(ring_of(polygon, face.ring_index), face.edge, first_of_ring[face.ring_index]);
    const Ring ring = without_double_nodes(face.ring);
    const End end = is_end(wing, ring) ? end_of(wing.own.plane.gradient * -1) : End::kHip;
    if (end == End::kHip)
      add(base, wing.own, ring.size() < 3 ? Ring{} : ring);
    else
      close_end(base, wing, ring, end == End::kHalfHip);
  }
  return base;
}

}  // namespace citykiln::roofs
