// Skeleton: Felkel and Obdržálek 1998. Gables after Laycock and Day 2003, where the faces beside the end of a wing are
// extended over it. They move a node of the skeleton; here the triangle of the end is cut instead, so that the rest of
// the skeleton does not change.
#include <algorithm>
#include <cmath>

#include "grammars/roofs/inset_facets.h"

namespace citykiln::roofs {
namespace {

// The cosine of 30 degrees: walls at a smaller angle are nearly parallel.
constexpr double kNearlyParallel = 0.866;
// Closer nodes are merged: CGAL duplicates nodes where several events coincide.
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

// The planes over an edge and its neighbours.
struct Wing {
  Facet before, own, after;
};

Facet facet_over(const Ring& ring, std::uint32_t edge, std::uint32_t first_face) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  return {.ring = {}, .plane = distance_left_of(ring[edge % n], ring[(edge + 1) % n]), .face = first_face + edge % n};
}

Wing wing_at(const Ring& ring, std::uint32_t edge, std::uint32_t first_face) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  return {facet_over(ring, edge + n - 1, first_face), facet_over(ring, edge, first_face),
          facet_over(ring, edge + 1, first_face)};
}

bool is_end(const Wing& wing, const Ring& face) {
  return face.size() == 3 && dot(wing.before.plane.gradient, wing.after.plane.gradient) < -kNearlyParallel;
}

void add(InsetFacets& inset, Facet facet, Ring ring) {
  if (ring.empty()) return;
  for (const Vec2 p : ring) inset.span_m = std::max(inset.span_m, facet.plane.at(p));
  facet.ring = std::move(ring);
  inset.facets.push_back(std::move(facet));
}

// Extends the neighbours of an end over it. For a half hip its own plane remains where it is lower, from half way up.
void close_end(InsetFacets& inset, Wing wing, const Ring& face, bool is_half) {
  const Vec2 a = face[0], b = face[1], top = face[2];
  const double after_m = wing.after.plane.at(a), before_m = wing.before.plane.at(b);
  const Vec2 middle = a + (b - a) * (after_m / (after_m + before_m));
  const Ring first = {a, middle, top}, second = {middle, b, top};
  if (!is_half) {
    add(inset, wing.before, first);
    return add(inset, wing.after, second);
  }
  wing.own.plane.offset += wing.own.plane.at(top) / 2;
  const Plane over_before = combined(1, wing.own.plane, -1, wing.before.plane);
  const Plane over_after = combined(1, wing.own.plane, -1, wing.after.plane);
  add(inset, wing.before, clipped(first, over_before));
  add(inset, wing.after, clipped(second, over_after));
  add(inset, wing.own,
      clipped(clipped(face, combined(-1, over_before, 0, over_before)), combined(-1, over_after, 0, over_after)));
}

// A face of the skeleton and the form at its edge.
struct Side {
  Wing wing;
  Ring face;
  std::uint32_t before, after;  // the neighbours, among all sides
  WingEnd end = WingEnd::kHip;
  double width_m = 0;
};

std::vector<Side> sides_of(const Polygon& polygon, const std::vector<SkeletonFace>& faces, std::uint32_t first_face) {
  std::vector<Side> sides;
  for (std::uint32_t first = 0, end = 0; first < faces.size(); first = end) {
    const Ring& ring = ring_of(polygon, faces[first].ring_index);
    const auto n = static_cast<std::uint32_t>(ring.size());
    end = first + n;
    for (std::uint32_t i = 0; i < n; ++i)
      sides.push_back({wing_at(ring, i, first_face + first), without_double_nodes(faces[first + i].ring),
                       first + (i + n - 1) % n, first + (i + 1) % n, WingEnd::kHip,
                       distance(ring[i], ring[(i + 1) % n])});
  }
  return sides;
}

// Chooses ends from the narrowest on; the neighbours of an end are no ends.
void choose_ends(std::vector<Side>& sides, const WingEndOf& end_of) {
  std::vector<std::uint32_t> ends;
  for (std::uint32_t i = 0; i < sides.size(); ++i)
    if (is_end(sides[i].wing, sides[i].face)) ends.push_back(i);
  // widths are compared in steps of 1/64 m, so that rounding has no effect
  std::stable_sort(ends.begin(), ends.end(), [&](auto i, auto j) {
    return std::floor(sides[i].width_m * 64) < std::floor(sides[j].width_m * 64);
  });
  std::vector<bool> is_wall(sides.size());
  for (const std::uint32_t i : ends) {
    if (is_wall[i]) continue;
    sides[i].end = end_of(sides[i].wing.own.plane.gradient * -1);
    is_wall[sides[i].before] = is_wall[sides[i].after] = true;
  }
}

}  // namespace

InsetFacets skeleton_facets(const Polygon& polygon, SkeletonKernel kernel, const WingEndOf& end_of,
                            std::uint32_t first_face) {
  std::vector<Side> sides = sides_of(polygon, straight_skeleton(polygon, kernel), first_face);
  choose_ends(sides, end_of);
  InsetFacets inset;
  for (const Side& side : sides)
    if (side.end != WingEnd::kHip)
      close_end(inset, side.wing, side.face, side.end == WingEnd::kHalfHip);
    else if (side.face.size() >= 3)
      add(inset, side.wing.own, side.face);
  return inset;
}

}  // namespace citykiln::roofs
