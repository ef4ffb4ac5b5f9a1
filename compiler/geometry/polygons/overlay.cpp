#include "compiler/geometry/polygons/overlay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace citykiln {
namespace {

constexpr std::uint32_t kNobody = 0xffffffffu;

// The top owners left and right of an edge, seen from its a to its b.
struct Sides {
  std::uint32_t left = kNobody, right = kNobody;
};

// The winding number of a point for each owner.
class Windings {
 public:
  explicit Windings(std::uint32_t owners) : counts_(owners) {}
  void clear() { std::fill(counts_.begin(), counts_.end(), 0); }
  void cross(std::span<const WindingStep> steps, int sign) {
    for (const WindingStep& step : steps) counts_[step.owner] += sign * step.winding;
  }
  std::uint32_t top() const {
    const auto first = std::find_if(counts_.begin(), counts_.end(), [](int count) { return count > 0; });
    return first == counts_.end() ? kNobody : static_cast<std::uint32_t>(first - counts_.begin());
  }

 private:
  std::vector<std::int32_t> counts_;
};

// An arrangement relative to its own corner, in half units: edge midpoints are integers and products fit into 64 bits.
struct Local {
  const Arrangement& arrangement;
  std::vector<GridPoint> vertices;

  explicit Local(const Arrangement& of) : arrangement(of) {
    const GridPoint corner = of.vertices.empty() ? GridPoint{} : of.vertices.front();
    for (const GridPoint p : of.vertices) vertices.push_back({2 * (p.x - corner.x), 2 * (p.y - corner.y)});
  }
  std::span<const WindingStep> steps(const ArrangedEdge& e) const { return {&arrangement.steps[e.first], e.count}; }
};

// Edges that count crossings, in parallel stripes of the plane, each in the arrangement's order: a ray along a stripe
// meets no others.
class Stripes {
 public:
  // are_level: stripes along x, one above the other; else along y, side by side
  Stripes(const Local& local, bool are_level) : are_level_(are_level) {
    const std::vector<ArrangedEdge>& edges = local.arrangement.edges;
    if (edges.empty()) return;
    const auto [low, high] = std::ranges::minmax(local.vertices, {}, [&](GridPoint p) { return across(p); });
    low_ = across(low);
    const auto count = static_cast<std::int64_t>(edges.size() / kEdgesOfStripe + 1);
    width_ = (across(high) - low_) / count + 1;
    stripes_.resize(static_cast<std::size_t>(count));
    for (const ArrangedEdge& edge : edges) {
      const auto [from, to] = std::minmax({across(local.vertices[edge.a]), across(local.vertices[edge.b])});
      if (edge.count > 0 && from < to)
        for (std::size_t i = stripe(from); i <= stripe(to); ++i) stripes_[i].push_back(&edge);
    }
  }
  std::span<const ArrangedEdge* const> about(GridPoint p) const { return stripes_[stripe(across(p))]; }

 private:
  static constexpr std::size_t kEdgesOfStripe = 4;
  std::int64_t across(GridPoint p) const { return are_level_ ? p.y : p.x; }
  std::size_t stripe(std::int64_t at) const { return static_cast<std::size_t>((at - low_) / width_); }

  bool are_level_;
  std::int64_t low_ = 0, width_ = 1;
  std::vector<std::vector<const ArrangedEdge*>> stripes_;
};

// Counts crossings along a ray from the far west (for horizontal edges from the far south) to the edge's midpoint.
Sides sides_of(const Local& local, const ArrangedEdge& edge, const Stripes& rows, const Stripes& columns,
               Windings& windings) {
  const GridPoint a = local.vertices[edge.a], b = local.vertices[edge.b];
  const GridPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const bool is_level = a.y == b.y;
  const auto along = [&](GridPoint p) { return is_level ? p.x : p.y; };
  windings.clear();
  for (const ArrangedEdge* other : (is_level ? columns : rows).about(middle)) {
    if (other == &edge) continue;
    const GridPoint c = local.vertices[other->a], d = local.vertices[other->b];
    // vertices are sorted by x, so no further edge begins west of the midpoint
    if (c.x > middle.x) break;
    if ((along(c) <= along(middle)) == (along(d) <= along(middle))) continue;
    const std::int64_t side = turn(c, d, middle);  // > 0: the midpoint lies to the left
    const bool rises = along(d) > along(c);
    // a rising edge has west on its left and south on its right
    const bool is_passed = is_level ? rises == (side > 0) : rises == (side < 0);
    if (is_passed) windings.cross(local.steps(*other), side > 0 ? 1 : -1);
  }
  // the ray ends just west of the edge, or just south of it
  const bool stand_left = !is_level && b.y > a.y;
  const std::uint32_t here = windings.top();
  windings.cross(local.steps(edge), stand_left ? -1 : 1);
  const std::uint32_t beyond = windings.top();
  return stand_left ? Sides{here, beyond} : Sides{beyond, here};
}

// A border edge of one owner, which lies to its left.
struct Border {
  std::uint32_t owner, from, to;
};

bool lies_before(const Border& a, const Border& b) {
  return std::tie(a.owner, a.from, a.to) < std::tie(b.owner, b.from, b.to);
}

std::vector<Border> borders_of(const Local& local, std::uint32_t owner_count) {
  std::vector<Border> borders;
  Windings windings(owner_count);
  const Stripes rows(local, true), columns(local, false);
  for (const ArrangedEdge& edge : local.arrangement.edges) {
    if (edge.count == 0) continue;
    const Sides sides = sides_of(local, edge, rows, columns, windings);
    if (sides.left == sides.right) continue;
    if (sides.left != kNobody) borders.push_back({sides.left, edge.a, edge.b});
    if (sides.right != kNobody) borders.push_back({sides.right, edge.b, edge.a});
  }
  std::sort(borders.begin(), borders.end(), lies_before);
  return borders;
}

// True if u comes before v in clockwise order from `start`. All three directions must differ.
bool is_sooner_clockwise(GridPoint start, GridPoint u, GridPoint v) {
  const auto cross = [](GridPoint p, GridPoint q) { return p.x * q.y - p.y * q.x; };
  const auto dot = [](GridPoint p, GridPoint q) { return p.x * q.x + p.y * q.y; };
  // 0: less than half a turn away, 1: half a turn, 2: more, 3: a full turn
  const auto half = [&](GridPoint p) {
    const std::int64_t c = cross(start, p);
    return c < 0 ? 0 : c > 0 ? 2 : dot(start, p) < 0 ? 1 : 3;
  };
  const int hu = half(u), hv = half(v);
  return hu != hv ? hu < hv : cross(u, v) < 0;
}

// Links the border edges of one owner into closed paths: each vertex continues with the edge that bounds the same
// corner.
class Tracer {
 public:
  Tracer(const Local& local, std::span<const Border> borders)
      : local_(local), borders_(borders), is_walked_(borders.size()) {}

  template <typename OnRing>
  void trace(OnRing on_ring) {
    for (std::size_t i = 0; i < borders_.size(); ++i)
      if (!is_walked_[i]) split(walk(i), on_ring);
  }

 private:
  GridPoint direction(std::uint32_t from, std::uint32_t to) const {
    return {local_.vertices[to].x - local_.vertices[from].x, local_.vertices[to].y - local_.vertices[from].y};
  }

  std::size_t next_after(const Border& border) const {
    const auto first =
        std::lower_bound(borders_.begin(), borders_.end(), Border{border.owner, border.to, 0}, lies_before);
    std::size_t best = borders_.size();
    for (auto i = static_cast<std::size_t>(first - borders_.begin());
         i < borders_.size() && borders_[i].from == border.to; ++i) {
      if (is_walked_[i]) continue;
      const GridPoint back = direction(border.to, border.from);
      if (best == borders_.size() || is_sooner_clockwise(back, direction(borders_[i].from, borders_[i].to),
                                                         direction(borders_[best].from, borders_[best].to)))
        best = i;
    }
    return best;
  }

  std::vector<std::uint32_t> walk(std::size_t start) {
    std::vector<std::uint32_t> path;
    for (std::size_t i = start; i < borders_.size(); i = next_after(borders_[i])) {
      is_walked_[i] = true;
      path.push_back(borders_[i].from);
      if (borders_[i].to == borders_[start].from) break;
    }
    return path;
  }

  // A path that returns to a vertex is split there into two rings that touch.
  template <typename OnRing>
  void split(const std::vector<std::uint32_t>& path, OnRing on_ring) const {
    std::vector<std::uint32_t> open;
    for (const std::uint32_t vertex : path) {
      const auto before = std::find(open.begin(), open.end(), vertex);
      if (before != open.end()) {
        on_ring(std::span<const std::uint32_t>(&*before, static_cast<std::size_t>(open.end() - before)));
        open.erase(before, open.end());
      }
      open.push_back(vertex);
    }
    if (!open.empty()) on_ring(std::span<const std::uint32_t>(open));
  }

  const Local& local_;
  std::span<const Border> borders_;
  std::vector<bool> is_walked_;
};

Ring plane_ring(const Arrangement& arrangement, std::span<const std::uint32_t> vertices) {
  Ring ring;
  for (const std::uint32_t v : vertices) ring.push_back(plane_point(arrangement.vertices[v]));
  return ring;
}

// A point half a step beside the middle of the hole's first edge, inside the polygon that has the hole.
Vec2 beside(const Ring& hole) {
  const Vec2 d = unit(hole[1] - hole[0]);
  return (hole[0] + hole[1]) * 0.5 + left_of(d) * 0x1p-12;
}

// Assigns each hole to the smallest outer ring around it.
std::vector<Polygon> polygons_of(std::vector<Ring> rings) {
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (Ring& ring : rings) {
    if (ring.size() < 3) continue;
    if (signed_area_m2(ring) > 0)
      polygons.push_back({std::move(ring), {}});
    else
      holes.push_back(std::move(ring));
  }
  for (Ring& hole : holes) {
    Polygon* smallest = nullptr;
    for (Polygon& polygon : polygons)
      if ((!smallest || signed_area_m2(polygon.outer) < signed_area_m2(smallest->outer)) &&
          winding_number(polygon.outer, beside(hole)) != 0)
        smallest = &polygon;
    if (smallest) smallest->holes.push_back(std::move(hole));
  }
  return polygons;
}

Box2 box_about(std::span<const OwnedSegment> segments) {
  Box2 box;
  for (const OwnedSegment& s : segments) {
    box.grow(plane_point(s.a));
    box.grow(plane_point(s.b));
  }
  return {{std::floor(box.min.x) - 1, std::floor(box.min.y) - 1}, {std::ceil(box.max.x) + 1, std::ceil(box.max.y) + 1}};
}

}  // namespace

std::vector<std::vector<Polygon>> overlay(std::span<const OwnedSegment> segments, std::uint32_t owner_count) {
  assert(std::ranges::all_of(segments, [&](const OwnedSegment& s) { return s.owner < owner_count; }));
  std::vector<std::vector<Polygon>> owned(owner_count);
  if (segments.empty()) return owned;
  const Arrangement arrangement = arrange(segments, {}, box_about(segments));
  const Local local(arrangement);
  const std::vector<Border> borders = borders_of(local, owner_count);
  for (std::size_t first = 0; first < borders.size();) {
    std::size_t last = first;
    while (last < borders.size() && borders[last].owner == borders[first].owner) ++last;
    std::vector<Ring> rings;
    Tracer(local, std::span(borders).subspan(first, last - first)).trace([&](std::span<const std::uint32_t> ring) {
      rings.push_back(plane_ring(arrangement, ring));
    });
    owned[borders[first].owner] = polygons_of(std::move(rings));
    first = last;
  }
  return owned;
}

void add_ring(std::vector<OwnedSegment>& segments, std::span<const Vec2> ring, std::uint32_t owner) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    segments.push_back({grid_point(ring[j]), grid_point(ring[i]), owner, 1});
}

std::vector<Polygon> difference(const Polygon& polygon, std::span<const Polygon> taken) {
  std::vector<OwnedSegment> segments;
  for (const Polygon& other : taken)
    for (const Ring* ring : rings_of(other)) add_ring(segments, *ring, 0);
  for (const Ring* ring : rings_of(polygon)) add_ring(segments, *ring, 1);
  return std::move(overlay(segments, 2)[1]);
}

}  // namespace citykiln
