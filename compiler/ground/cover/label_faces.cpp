#include "compiler/ground/cover/label_faces.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::ground {
namespace {

constexpr std::uint32_t kNoEdge = 0xffffffffu;

// Edges by their lower end.
struct EdgesByEnd {
  std::span<const ArrangedEdge> edges;
  std::vector<std::uint32_t> starts;  // one per vertex, and the end

  explicit EdgesByEnd(const Arrangement& arrangement) : edges(arrangement.edges) {
    starts.assign(arrangement.vertices.size() + 1, 0);
    for (const ArrangedEdge& e : edges) ++starts[e.a + 1];
    for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  }

  std::uint32_t between(std::uint32_t p, std::uint32_t q) const {
    const auto [low, high] = std::minmax(p, q);
    for (std::uint32_t e = starts[low]; e < starts[low + 1]; ++e)
      if (edges[e].b == high) return e;
    return kNoEdge;
  }
};

// The winding number of each owner at the current face, and the few owners with one above zero.
struct Inside {
  using Ranked = std::pair<std::uint32_t, std::uint32_t>;  // rank, owner
  std::span<const std::uint32_t> ranks;
  std::vector<std::int32_t> windings;
  std::vector<Ranked> covering;  // sorted

  explicit Inside(std::span<const std::uint32_t> r) : ranks(r), windings(r.size(), 0) {}

  void add(std::uint32_t owner, std::int32_t winding) {
    const bool was = windings[owner] > 0;
    windings[owner] += winding;
    const bool is = windings[owner] > 0;
    if (is == was) return;
    const Ranked ranked{ranks[owner], owner};
    const auto place = std::ranges::lower_bound(covering, ranked);
    is ? void(covering.insert(place, ranked)) : void(covering.erase(place));
  }
  std::uint32_t top() const { return covering.empty() ? kNoOwner : covering.front().second; }
};

// A step of the walk: the face reached, the edge crossed and in which direction.
struct Frame {
  std::uint32_t face;
  std::uint32_t edge = kNoEdge;
  std::int32_t sign = 0;
  int next = 0;  // the neighbour to visit next
};

void cross_edge(Inside& inside, const Arrangement& arrangement, const Frame& frame, std::int32_t sign) {
  if (frame.edge == kNoEdge) return;
  const ArrangedEdge& edge = arrangement.edges[frame.edge];
  for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i)
    inside.add(arrangement.steps[i].owner, sign * arrangement.steps[i].winding);
}

// Returns the step over edge i of a face.
Frame step_over(const Delaunay& triangulation, const EdgesByEnd& edges, std::uint32_t from, int i) {
  const DelaunayFace& face = triangulation.faces()[from];
  Frame frame{face.neighbours[i]};
  if (!face.is_constrained[i]) return frame;
  // the face lies to the left of p → q, so leaving it crosses from left to right
  const std::uint32_t p = face.vertices[(i + 1) % 3], q = face.vertices[(i + 2) % 3];
  frame.edge = edges.between(p, q);
  frame.sign = p < q ? -1 : 1;
  return frame;
}

}  // namespace

std::vector<std::uint32_t> label_faces(const Delaunay& triangulation, const Arrangement& arrangement,
                                       const LabelledFace& known, std::span<const std::uint32_t> ranks) {
  assert(known.face < triangulation.faces().size());
  std::vector<std::uint32_t> top(triangulation.faces().size(), kNoOwner);
  std::vector<bool> seen(top.size(), false);
  Inside inside(ranks);
  const EdgesByEnd edges(arrangement);
  for (const WindingStep& step : known.windings) inside.add(step.owner, step.winding);
  std::vector<Frame> walk;
  const auto enter = [&](const Frame& frame) {
    cross_edge(inside, arrangement, frame, frame.sign);
    seen[frame.face] = true;
    top[frame.face] = inside.top();
    walk.push_back(frame);
  };
  enter(Frame{known.face});
  while (!walk.empty()) {
    Frame& here = walk.back();
    if (here.next == 3) {
      cross_edge(inside, arrangement, here, -here.sign);
      walk.pop_back();
      continue;
    }
    const int i = here.next++;
    const std::uint32_t neighbour = triangulation.faces()[here.face].neighbours[i];
    if (neighbour != kNoFace && !seen[neighbour]) enter(step_over(triangulation, edges, here.face, i));
  }
  return top;
}

WidestFace widest_face(const Delaunay& triangulation) {
  WidestFace widest;
  double largest_radius = -1;
  for (std::uint32_t f = 0; f < triangulation.faces().size(); ++f) {
    std::array<Vec2, 3> corner;
    for (int i = 0; i < 3; ++i) {
      const GridPoint p = triangulation.vertices()[triangulation.faces()[f].vertices[i]];
      corner[i] = {static_cast<double>(p.x), static_cast<double>(p.y)};
    }
    const double a = distance(corner[1], corner[2]), b = distance(corner[2], corner[0]),
                 c = distance(corner[0], corner[1]);
    const double around = a + b + c;
    const double radius = cross(corner[1] - corner[0], corner[2] - corner[0]) / around;
    if (radius <= largest_radius) continue;
    largest_radius = radius;
    const Vec2 centre = (corner[0] * a + corner[1] * b + corner[2] * c) * (1 / around);
    widest = {f, centre.x, centre.y};
  }
  return widest;
}

}  // namespace citykiln::ground
