// Felkel and Obdržálek 1998 for the skeleton; gables as by Laycock and Day 2003: the face of a wing's end is given to
// its neighbours. Theirs moves the face's node, ours cuts the face's triangle, so the rest of the skeleton stays as it
// is.
#include <algorithm>
#include <cmath>

#include "grammars/roofs/inset_facets.h"

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

void add(InsetFacets& base, Facet facet, Ring ring) {
  if (ring.empty()) return;
  for (const Vec2 p : ring) base.span_m = std::max(base.span_m, facet.plane.at(p));
  facet.ring = std::move(ring);
  base.facets.push_back(std::move(facet));
}

// The neighbours meet over the end; what the end's own plane, raised, leaves lower is a half hip.
void close_end(InsetFacets& base, Wing wing, const Ring& face, bool is_half) {
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

// One face of the skeleton, and what stands at its edge.
struct Side {
  Wing wing;
  Ring face;
  std::uint32_t before, after;  // the neighbours, among all sides
  End end = End::kHip;
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
                       first + (i + n - 1) % n, first + (i + 1) % n, End::kHip, distance(ring[i], ring[(i + 1) % n])});
  }
  return sides;
}

// Ends, the narrowest first; an end's neighbours are walls, so they are none.
void choose_ends(std::vector<Side>& sides, const WingEndOf& end_of) {
  std::vector<std::uint32_t> ends;
  for (std::uint32_t i = 0; i < sides.size(); ++i)
    if (is_end(sides[i].wing, sides[i].face)) ends.push_back(i);
  // a millimetre decides nothing
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
  InsetFacets base;
  for (const Side& side : sides)
    if (side.end != End::kHip)
      close_end(base, side.wing, side.face, side.end == End::kHalfHip);
    else if (side.face.size() >= 3)
      add(base, side.wing.own, side.face);
  return base;
}

}  // namespace citykiln::roofs
