// Snap rounding after Hobby 1999, with two differences: the border lines of cells are part of the arrangement, so that
// each cell can be computed separately; hot points are found in a bucket grid instead of by a sweep.
#include "compiler/geometry/arrangement.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/bucket_grid.h"

namespace citykiln {
namespace {

using Int = std::int64_t;
__extension__ using Wide = __int128;

struct GridBox {
  GridPoint min, max;
  bool contains(GridPoint p) const { return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y; }
  bool has_on_border(GridPoint p) const { return p.x == min.x || p.x == max.x || p.y == min.y || p.y == max.y; }
};

GridPoint operator-(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y}; }
Int cross(GridPoint a, GridPoint b) { return a.x * b.y - a.y * b.x; }
Int dot(GridPoint a, GridPoint b) { return a.x * b.x + a.y * b.y; }

// The integer nearest to n / d; halves round up. d > 0.
Int rounded_quotient(Wide n, Wide d) {
  const Wide twice = 2 * n + d, divisor = 2 * d;
  Wide quotient = twice / divisor;
  if (twice % divisor < 0) --quotient;
  return static_cast<Int>(quotient);
}

// The crossing point of two segments, rounded to the grid. Empty for parallel or disjoint segments and for segments
// that meet at an end, which is already a hot point.
std::optional<GridPoint> rounded_crossing(const OwnedSegment& s, const OwnedSegment& t) {
  const GridPoint along = s.b - s.a, other = t.b - t.a, between = t.a - s.a;
  Int d = cross(along, other), n = cross(between, other), m = cross(between, along);
  if (d == 0) return std::nullopt;
  if (d < 0) d = -d, n = -n, m = -m;
  if (n <= 0 || n >= d || m <= 0 || m >= d) return std::nullopt;
  return GridPoint{s.a.x + rounded_quotient(Wide{along.x} * n, d), s.a.y + rounded_quotient(Wide{along.y} * n, d)};
}

// A parameter n / d along a segment from a to b, d > 0.
struct Fraction {
  Int n = 0, d = 1;
};
bool less(Fraction a, Fraction b) { return Wide{a.n} * b.d < Wide{b.n} * a.d; }

// An interval of parameters, each end open or closed.
struct Stretch {
  Fraction from{0, 1}, to{1, 1};
  bool has_from = true, has_to = true;

  void begin_at(Fraction f, bool inclusive) {
    if (less(from, f))
      from = f, has_from = inclusive;
    else if (!less(f, from))
      has_from = has_from && inclusive;
  }
  void end_at(Fraction f, bool inclusive) {
    if (less(f, to))
      to = f, has_to = inclusive;
    else if (!less(to, f))
      has_to = has_to && inclusive;
  }
  bool is_empty() const { return less(to, from) || (!less(from, to) && !(has_from && has_to)); }
};

// Restricts the interval to low <= start + step · t < high.
void keep_between(Stretch& stretch, Int start, Int step, Int low, Int high) {
  if (step > 0) {
    stretch.begin_at({low - start, step}, true);
    stretch.end_at({high - start, step}, false);
  } else if (step < 0) {
    stretch.begin_at({start - high, -step}, false);
    stretch.end_at({start - low, -step}, true);
  } else if (start < low || start >= high) {
    stretch.end_at({-1, 1}, false);
  }
}

}  // namespace

// The half-open unit square about p is the set of points that round to p.
bool passes(const OwnedSegment& s, GridPoint p) {
  const GridPoint along = s.b - s.a;
  // rejects most points: the line misses the whole square
  if (2 * std::abs(cross(along, p - s.a)) > std::abs(along.x) + std::abs(along.y)) return false;
  Stretch stretch;
  keep_between(stretch, 2 * s.a.x, 2 * (s.b.x - s.a.x), 2 * p.x - 1, 2 * p.x + 1);
  keep_between(stretch, 2 * s.a.y, 2 * (s.b.y - s.a.y), 2 * p.y - 1, 2 * p.y + 1);
  return !stretch.is_empty();
}

namespace {

// Square buckets over the cell. Points within a grid step outside the cell fall into the outermost buckets.
struct Buckets {
  GridBox cell;
  Int side;
  Int count;  // per row and column

  Buckets(const GridBox& box, std::size_t things) : cell(box) {
    // about two items per bucket, at most 128 buckets a side
    count = std::clamp<Int>(static_cast<Int>(std::sqrt(static_cast<double>(things) / 2)), 1, 128);
    side = std::max<Int>(1, (std::max(box.max.x - box.min.x, box.max.y - box.min.y) + count - 1) / count);
  }
  Int column(Int x) const { return std::clamp<Int>((x - cell.min.x) / side, 0, count - 1); }
  Int row(Int y) const { return std::clamp<Int>((y - cell.min.y) / side, 0, count - 1); }
  std::size_t size() const { return static_cast<std::size_t>(count * count); }
  std::size_t index(Int c, Int r) const { return static_cast<std::size_t>(r * count + c); }

  // Calls visit(bucket) for every bucket that the segment, widened by one grid step, may touch.
  template <typename Visit>
  void for_each_along(const OwnedSegment& s, Visit visit) const {
    const auto [low, high] = s.a.y < s.b.y ? std::pair(s.a, s.b) : std::pair(s.b, s.a);
    const double slope = high.y > low.y ? static_cast<double>(high.x - low.x) / static_cast<double>(high.y - low.y) : 0;
    const Int least_x = std::min(low.x, high.x) - 2, most_x = std::max(low.x, high.x) + 2;
    for (Int r = row(low.y - 1); r <= row(high.y + 1); ++r) {
      // the x interval in this row of buckets; the outermost rows extend to the segment's ends
      const Int row_low = r == 0 ? low.y : std::max(low.y, cell.min.y + r * side - 2);
      const Int row_high = r == count - 1 ? high.y : std::min(high.y, cell.min.y + (r + 1) * side + 2);
      double x0 = static_cast<double>(low.x), x1 = static_cast<double>(high.x);
      if (high.y > low.y) {
        x0 = static_cast<double>(low.x) + slope * static_cast<double>(row_low - low.y);
        x1 = static_cast<double>(low.x) + slope * static_cast<double>(row_high - low.y);
      }
      const Int from = std::max(least_x, static_cast<Int>(std::floor(std::min(x0, x1))) - 2);
      const Int to = std::min(most_x, static_cast<Int>(std::ceil(std::max(x0, x1))) + 2);
      if (to < cell.min.x - 2 || from > cell.max.x + 2) continue;
      for (Int c = column(from); c <= column(to); ++c) visit(index(c, r));
    }
  }
};

GridBox grid_box(const Box2& cell) { return {grid_point(cell.min), grid_point(cell.max)}; }

std::vector<OwnedSegment> touching(std::span<const OwnedSegment> segments, const GridBox& cell) {
  std::vector<OwnedSegment> near;
  for (const OwnedSegment& s : segments) {
    const bool outside = std::max(s.a.x, s.b.x) < cell.min.x - 1 || std::min(s.a.x, s.b.x) > cell.max.x + 1 ||
                         std::max(s.a.y, s.b.y) < cell.min.y - 1 || std::min(s.a.y, s.b.y) > cell.max.y + 1;
    if (!outside && s.a != s.b) near.push_back(s);
  }
  return near;
}

std::array<OwnedSegment, 4> border_of(const GridBox& cell) {
  const GridPoint sw = cell.min, ne = cell.max, se{ne.x, sw.y}, nw{sw.x, ne.y};
  return {{{sw, se, 0, 0}, {se, ne, 0, 0}, {nw, ne, 0, 0}, {sw, nw, 0, 0}}};
}

// Returns the rounded crossings in the cell, some of them several times.
std::vector<GridPoint> crossings_of(std::span<const OwnedSegment> segments, const GridBox& cell) {
  std::vector<GridPoint> crossings;
  const Buckets buckets(cell, segments.size());
  const BucketItems sorted = sort_into_buckets(buckets.size(), [&](auto visit) {
    for (std::uint32_t i = 0; i < segments.size(); ++i)
      buckets.for_each_along(segments[i], [&](std::size_t bucket) { visit(bucket, i); });
  });
  for (std::size_t bucket = 0; bucket + 1 < sorted.starts.size(); ++bucket) {
    const auto here = sorted.in(bucket);
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = i + 1; j < here.size(); ++j)
        if (const auto p = rounded_crossing(segments[here[i]], segments[here[j]]); p && cell.contains(*p))
          crossings.push_back(*p);
  }
  return crossings;
}

// Returns all crossings, segment ends and further points in the cell, sorted.
std::vector<GridPoint> hot_points(std::vector<GridPoint> crossings, std::span<const OwnedSegment> segments,
                                  std::span<const GridPoint> points, const GridBox& cell) {
  std::vector<GridPoint> hot = std::move(crossings);
  const auto add = [&](GridPoint p) {
    if (cell.contains(p)) hot.push_back(p);
  };
  for (const GridPoint p : points) add(p);
  for (const OwnedSegment& s : segments) add(s.a), add(s.b);
  std::sort(hot.begin(), hot.end());
  hot.erase(std::unique(hot.begin(), hot.end()), hot.end());
  return hot;
}

// The part of a segment between two consecutive hot points on it.
struct Piece {
  std::uint32_t a, b, owner;
  std::int32_t winding;
};

// Splits every segment at the hot points for which meets(segment, point) is true, in order along the segment.
template <typename Meets>
std::vector<Piece> bend_through(std::span<const OwnedSegment> segments, std::span<const GridPoint> hot,
                                const GridBox& cell, Meets meets) {
  const Buckets buckets(cell, hot.size());
  const BucketItems sorted = sort_into_buckets(buckets.size(), [&](auto visit) {
    for (std::uint32_t i = 0; i < hot.size(); ++i)
      visit(buckets.index(buckets.column(hot[i].x), buckets.row(hot[i].y)), i);
  });
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> passed;
  for (const OwnedSegment& s : segments) {
    passed.clear();
    buckets.for_each_along(s, [&](std::size_t bucket) {
      for (const std::uint32_t p : sorted.in(bucket))
        if (meets(s, hot[p])) passed.push_back(p);
    });
    // the squares are disjoint and the segment is straight, so sorting their centres along it is exact
    const GridPoint along = s.b - s.a;
    std::sort(passed.begin(), passed.end(),
              [&](auto p, auto q) { return dot(hot[p] - s.a, along) < dot(hot[q] - s.a, along); });
    for (std::size_t i = 1; i < passed.size(); ++i) {
      const std::uint32_t a = passed[i - 1], b = passed[i];
      if (a < b) pieces.push_back({a, b, s.owner, s.winding});
      if (b < a) pieces.push_back({b, a, s.owner, -s.winding});
    }
  }
  return pieces;
}

// Merges coincident pieces; drops edges whose windings cancel, except those on the cell's border.
Arrangement join(std::vector<Piece> pieces, std::vector<GridPoint> hot, const GridBox& cell) {
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& p, const Piece& q) { return std::tie(p.a, p.b, p.owner) < std::tie(q.a, q.b, q.owner); });
  Arrangement arrangement{std::move(hot), {}, {}};
  const auto on_border = [&](const Piece& p) {
    const GridPoint a = arrangement.vertices[p.a], b = arrangement.vertices[p.b];
    return (a.x == b.x && (a.x == cell.min.x || a.x == cell.max.x)) ||
           (a.y == b.y && (a.y == cell.min.y || a.y == cell.max.y));
  };
  for (std::size_t i = 0; i < pieces.size();) {
    const Piece& edge = pieces[i];
    const auto first = static_cast<std::uint32_t>(arrangement.steps.size());
    for (; i < pieces.size() && pieces[i].a == edge.a && pieces[i].b == edge.b;) {
      WindingStep step{pieces[i].owner, 0};
      for (; i < pieces.size() && pieces[i].a == edge.a && pieces[i].b == edge.b && pieces[i].owner == step.owner; ++i)
        step.winding += pieces[i].winding;
      if (step.winding != 0) arrangement.steps.push_back(step);
    }
    const auto count = static_cast<std::uint32_t>(arrangement.steps.size()) - first;
    if (count > 0 || on_border(edge)) arrangement.edges.push_back({edge.a, edge.b, first, count});
  }
  return arrangement;
}

// Returns whether a segment of the closed cell goes exactly through p.
bool goes_through(const OwnedSegment& s, GridPoint p) { return passes(s, p) && turn(s.a, s.b, p) == 0; }

// Removes vertices without edges.
void drop_unused(Arrangement& arrangement) {
  std::vector<std::uint32_t> place(arrangement.vertices.size(), 0);
  for (const ArrangedEdge& e : arrangement.edges) place[e.a] = place[e.b] = 1;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    arrangement.vertices[kept] = arrangement.vertices[i];
    place[i] = kept++;
  }
  arrangement.vertices.resize(kept);
  for (ArrangedEdge& e : arrangement.edges) e.a = place[e.a], e.b = place[e.b];
}

// Bends segments through hot points and joins what coincides.
template <typename Meets>
Arrangement arranged(std::span<const OwnedSegment> segments, std::vector<GridPoint> hot, const GridBox& box,
                     Meets meets) {
  std::vector<Piece> pieces = bend_through(segments, hot, box, meets);
  Arrangement arrangement = join(std::move(pieces), std::move(hot), box);
  drop_unused(arrangement);
  return arrangement;
}

std::vector<OwnedSegment> with_border(std::vector<OwnedSegment> segments, const GridBox& box) {
  for (const OwnedSegment& side : border_of(box)) segments.push_back(side);
  return segments;
}

[[maybe_unused]] bool is_whole(const Box2& cell) {
  return !cell.is_empty() && cell.min.x == std::floor(cell.min.x) && cell.min.y == std::floor(cell.min.y) &&
         cell.max.x == std::floor(cell.max.x) && cell.max.y == std::floor(cell.max.y);
}

// Arranges segments of the closed cell. Returns nothing where a crossing is one that cannot be.
template <typename CannotBe, typename Meets>
std::optional<Arrangement> arranged_in_cell(std::span<const OwnedSegment> segments, std::span<const GridPoint> points,
                                            const Box2& cell, CannotBe cannot_be, Meets meets) {
  assert(is_whole(cell));
  const GridBox box = grid_box(cell);
  assert(std::ranges::all_of(segments, [&](const auto& s) { return box.contains(s.a) && box.contains(s.b); }));
  const std::vector<OwnedSegment> near = with_border(touching(segments, box), box);
  std::vector<GridPoint> crossings = crossings_of(near, box);
  if (std::ranges::any_of(crossings, cannot_be)) return std::nullopt;
  return arranged(near, hot_points(std::move(crossings), near, points, box), box, meets);
}

}  // namespace

Arrangement arrange(std::span<const OwnedSegment> segments, std::span<const GridPoint> points, const Box2& cell) {
  assert(is_whole(cell));
  const GridBox box = grid_box(cell);
  const std::vector<OwnedSegment> near = with_border(touching(segments, box), box);
  const auto meets = [](const OwnedSegment& s, GridPoint p) { return passes(s, p); };
  return arranged(near, hot_points(crossings_of(near, box), near, points, box), box, meets);
}

std::optional<Arrangement> arrange_inside(std::span<const OwnedSegment> segments, std::span<const GridPoint> points,
                                          const Box2& cell) {
  const GridBox box = grid_box(cell);
  const auto is_on_border = [&](GridPoint p) { return box.has_on_border(p); };
  const auto meets = [&](const OwnedSegment& s, GridPoint p) {
    return is_on_border(p) ? goes_through(s, p) : passes(s, p);
  };
  return arranged_in_cell(segments, points, cell, is_on_border, meets);
}

std::optional<Arrangement> arrange_exactly(std::span<const OwnedSegment> segments, std::span<const GridPoint> points,
                                           const Box2& cell) {
  const auto always = [](GridPoint) { return true; };
  return arranged_in_cell(segments, points, cell, always, goes_through);
}

}  // namespace citykiln
