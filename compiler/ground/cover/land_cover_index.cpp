#include "compiler/ground/cover/land_cover_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::ground {
namespace {

// Half a grid step: the sides of buckets lie between the plane's grid lines.
constexpr double kOffGrid_m = 0x1p-11;

// An edge and a bucket it comes near, numbered within the bucket range of the polygon.
struct BucketEdge {
  std::uint32_t bucket;
  LandCoverIndex::Edge edge;
};

// Returns false only where all corners of the bucket lie on one side of the edge.
bool may_pass(const LandCoverIndex& land_cover, int column, int row, Vec2 a, Vec2 b) {
  const Vec2 along = b - a,
             centre = land_cover.corner_of(column, row) + Vec2{land_cover.bucket_m / 2, land_cover.bucket_m / 2};
  return std::abs(cross(along, centre - a)) <=
         (land_cover.bucket_m / 2 + kOffGrid_m) * (std::abs(along.x) + std::abs(along.y));
}

// The edges of one polygon, sorted by bucket of the range that its box touches.
struct Sorted {
  BucketRange range;
  std::vector<BucketEdge> edges;
};

Sorted sort_edges(const LandCoverIndex& land_cover, const LandCoverPolygon& surface, const Box2& box) {
  Sorted sorted{land_cover.range(box), {}};
  const BucketRange& range = sorted.range;
  const int across = range.last_column - range.first_column + 1;
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Box2 edge = box_of_segment(ring[j], ring[i]);
      if (!edge.touches(land_cover.box)) continue;
      const BucketRange near = land_cover.range(edge);
      for_each_bucket(near, [&](int c, int r) {
        if (may_pass(land_cover, c, r, ring[j], ring[i]))
          sorted.edges.push_back({static_cast<std::uint32_t>((r - range.first_row) * across + c - range.first_column),
                                  {ring[j], ring[i]}});
      });
    }
  std::ranges::stable_sort(sorted.edges, {}, &BucketEdge::bucket);
  return sorted;
}

// The side test of winding_number().
bool is_west_of(Vec2 a, Vec2 b, Vec2 p) { return a.y <= p.y ? cross(b - a, p - a) > 0 : cross(b - a, p - a) < 0; }

// Winding numbers at the corners of a range of buckets, row by row: each edge is counted once per row it crosses, not
// once per bucket.
struct Windings {
  const LandCoverIndex& land_cover;
  BucketRange range;
  std::vector<int> steps;  // differences along a row, which has one more than columns

  int across() const { return range.last_column - range.first_column + 1; }
  int* row(int r) { return &steps[static_cast<std::size_t>(r - range.first_row) * (across() + 1)]; }

  // Returns how many columns, from the west, have their corner west of where the edge crosses row r.
  int columns_west(Vec2 a, Vec2 b, int r) const {
    const double y = land_cover.corner_of(0, r).y, x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    int count =
        static_cast<int>(std::clamp(std::ceil((x - land_cover.corner.x) / land_cover.bucket_m) - range.first_column,
                                    0.0, static_cast<double>(across())));
    const auto is_west = [&](int column) {
      return is_west_of(a, b, land_cover.corner_of(range.first_column + column, r));
    };
    while (count > 0 && !is_west(count - 1)) --count;
    while (count < across() && is_west(count)) ++count;
    return count;
  }

  void add_edge(Vec2 a, Vec2 b) {
    const BucketRange rows = land_cover.range(box_of_segment(a, b));
    const int last = std::min(rows.last_row + 1, range.last_row);
    for (int r = std::max(rows.first_row, range.first_row); r <= last; ++r) {
      const double y = land_cover.corner_of(0, r).y;
      if ((a.y <= y) == (b.y <= y)) continue;
      const int winding = a.y <= y ? 1 : -1;
      row(r)[0] += winding, row(r)[columns_west(a, b, r)] -= winding;
    }
  }
};

// Returns one winding number per bucket of the range.
std::vector<int> windings_of(const LandCoverIndex& land_cover, const LandCoverPolygon& surface,
                             const BucketRange& range) {
  Windings windings{land_cover, range, {}};
  windings.steps.assign(static_cast<std::size_t>(windings.across() + 1) * (range.last_row - range.first_row + 1), 0);
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) windings.add_edge(ring[j], ring[i]);
  std::vector<int> sums;
  for (int r = range.first_row; r <= range.last_row; ++r)
    for (int c = 0, winding = 0; c < windings.across(); ++c) sums.push_back(winding += windings.row(r)[c]);
  return sums;
}

// An entry of the index before it is sorted into its bucket.
struct Found {
  std::size_t bucket;
  BucketEntry entry;
};

void find_in_buckets(const LandCoverIndex& land_cover, std::uint32_t number,
                     std::vector<LandCoverIndex::Edge>& all_edges, std::vector<Found>& found) {
  const LandCoverPolygon& surface = land_cover.surfaces[number];
  const Box2 box = box_of(surface);
  if (box.is_empty() || !box.touches(land_cover.box)) return;
  const Sorted sorted = sort_edges(land_cover, surface, box);
  const std::vector<int> windings = windings_of(land_cover, surface, sorted.range);
  const std::int32_t priority = map::values_of(surface.surface).priority;
  std::uint32_t at = 0;
  auto edge = sorted.edges.begin();
  for (int r = sorted.range.first_row; r <= sorted.range.last_row; ++r)
    for (int c = sorted.range.first_column; c <= sorted.range.last_column; ++c, ++at) {
      const auto first = static_cast<std::uint32_t>(all_edges.size());
      Box2 about;
      for (; edge != sorted.edges.end() && edge->bucket == at; ++edge) {
        all_edges.push_back(edge->edge);
        about.grow(edge->edge.a), about.grow(edge->edge.b);
      }
      const auto count = static_cast<std::uint32_t>(all_edges.size()) - first;
      if (count == 0 && windings[at] <= 0) continue;
      found.push_back(
          {land_cover.index(c, r), {number, windings[at], priority, surface.raised_priority > 0, first, count, about}});
    }
}

std::span<const LandCoverIndex::Edge> edges_of_entry(const LandCoverIndex& land_cover, const BucketEntry& entry) {
  return std::span(land_cover.edges).subspan(entry.first_edge, entry.edge_count);
}

// Counts winding steps from the bucket's corner, where the winding number is known, north to the height of p and then
// east to p.
bool covers_point(const LandCoverIndex& land_cover, const BucketEntry& entry, Vec2 corner, Vec2 p) {
  int winding = entry.winding;
  for (const auto& [a, b] : edges_of_entry(land_cover, entry)) {
    if ((a.x <= corner.x) != (b.x <= corner.x)) {
      const double y = a.y + (b.y - a.y) * ((corner.x - a.x) / (b.x - a.x));
      if (y > corner.y && y <= p.y) winding += a.x <= corner.x ? 1 : -1;
    }
    if ((a.y <= p.y) != (b.y <= p.y)) {
      const double x = a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
      if (x > corner.x && x <= p.x) winding += a.y <= p.y ? -1 : 1;
    }
  }
  return winding > 0;
}

double squared(double x) { return x * x; }

// To the nearest place of a box.
double squared_distance(const Box2& box, Vec2 p) {
  const double aside = std::max({box.min.x - p.x, p.x - box.max.x, 0.0});
  const double above = std::max({box.min.y - p.y, p.y - box.max.y, 0.0});
  return squared(aside) + squared(above);
}

double squared_distance(const LandCoverIndex& land_cover, int column, int row, Vec2 p) {
  return squared_distance({land_cover.corner_of(column, row), land_cover.corner_of(column + 1, row + 1)}, p);
}

// Returns the squared distance to the entry's edges if it is below `nearest`, else `nearest`. Only squares are
// compared, so the order of edges does not matter.
double squared_distance(const LandCoverIndex& land_cover, const BucketEntry& entry, Vec2 p, double nearest) {
  // most edges are farther than one found before
  if (squared_distance(entry.edges, p) >= nearest) return nearest;
  for (const auto& [a, b] : edges_of_entry(land_cover, entry)) {
    const Box2 box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
    if (squared_distance(box, p) >= nearest) continue;
    const Vec2 off = p - nearest_point(a, b, p);
    nearest = std::min(nearest, dot(off, off));
  }
  return nearest;
}

// Stores the entries sorted by bucket, and their edges in the same order, so that a query reads memory in a row.
void store_entries(LandCoverIndex& land_cover, std::span<const Found> found,
                   std::span<const LandCoverIndex::Edge> edges) {
  land_cover.bucket_starts.assign(land_cover.size() + 1, 0);
  land_cover.edges.reserve(edges.size());
  for (const Found& f : found) {
    ++land_cover.bucket_starts[f.bucket + 1];
    const auto own = edges.subspan(f.entry.first_edge, f.entry.edge_count);
    land_cover.entries.push_back(f.entry);
    land_cover.entries.back().first_edge = static_cast<std::uint32_t>(land_cover.edges.size());
    land_cover.edges.insert(land_cover.edges.end(), own.begin(), own.end());
  }
  for (std::size_t i = 1; i < land_cover.bucket_starts.size(); ++i)
    land_cover.bucket_starts[i] += land_cover.bucket_starts[i - 1];
}

std::span<const BucketEntry> entries_at(const LandCoverIndex& land_cover, int column, int row) {
  const std::size_t bucket = land_cover.index(column, row);
  return std::span(land_cover.entries)
      .subspan(land_cover.bucket_starts[bucket],
               land_cover.bucket_starts[bucket + 1] - land_cover.bucket_starts[bucket]);
}

// Returns per bucket whether no bucket with entries lies within kIndexNear_m.
std::vector<bool> far_buckets(const LandCoverIndex& land_cover) {
  std::vector<bool> is_far(land_cover.size(), true);
  const int near = static_cast<int>(std::ceil(kIndexNear_m / land_cover.bucket_m));
  for (int row = 0; row < land_cover.rows; ++row)
    for (int column = 0; column < land_cover.columns; ++column) {
      if (entries_at(land_cover, column, row).empty()) continue;
      for (int r = std::max(row - near, 0); r <= std::min(row + near, land_cover.rows - 1); ++r)
        for (int c = std::max(column - near, 0); c <= std::min(column + near, land_cover.columns - 1); ++c)
          is_far[land_cover.index(c, r)] = false;
    }
  return is_far;
}

}  // namespace

LandCoverIndex index_land_cover(std::span<const LandCoverPolygon> surfaces, const Box2& box, double bucket_m) {
  assert(bucket_m > 0);
  const auto count = [&](double side_m) {
    return std::max(1, static_cast<int>(std::ceil((side_m + kOffGrid_m) / bucket_m)));
  };
  LandCoverIndex land_cover;
  static_cast<BucketGrid&>(land_cover) = {box.min - Vec2{kOffGrid_m, kOffGrid_m}, bucket_m, count(box.width()),
                                          count(box.height())};
  land_cover.surfaces = surfaces, land_cover.box = box;
  std::vector<std::uint32_t> order(surfaces.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return covers(surfaces[a], surfaces[b]); });
  // entries are made from the top down, so a stable sort by bucket keeps each bucket's in that order
  std::vector<Found> found;
  std::vector<LandCoverIndex::Edge> edges;
  for (const std::uint32_t i : order) find_in_buckets(land_cover, i, edges, found);
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.bucket < b.bucket; });
  store_entries(land_cover, found, edges);
  land_cover.is_far = far_buckets(land_cover);
  return land_cover;
}

std::uint32_t land_cover_at(const LandCoverIndex& land_cover, Vec2 p) {
  assert(land_cover.box.contains(p));
  const int column = land_cover.column(p.x), row = land_cover.row(p.y);
  for (const BucketEntry& entry : entries_at(land_cover, column, row))
    if (covers_point(land_cover, entry, land_cover.corner_of(column, row), p)) return entry.polygon;
  return kNoLandCover;
}

double clearance_m(const LandCoverIndex& land_cover, Vec2 p, int priority, double search_radius_m) {
  assert(land_cover.box.contains(p) && search_radius_m >= 0);
  const int own_column = land_cover.column(p.x), own_row = land_cover.row(p.y);
  if (search_radius_m <= kIndexNear_m && land_cover.is_far[land_cover.index(own_column, own_row)])
    return search_radius_m;
  double nearest = squared(search_radius_m);
  bool is_on_raised = false;
  for (const BucketEntry& entry : entries_at(land_cover, own_column, own_row)) {
    // sorted from the top down: all that follow have a lower priority, unless this one is raised onto others
    if (entry.priority < priority && !entry.is_raised) break;
    const bool covers_p = covers_point(land_cover, entry, land_cover.corner_of(own_column, own_row), p);
    // beyond the edges of what is raised lies what it lies in
    if (entry.priority < priority && !covers_p) continue;
    is_on_raised |= entry.priority < priority;
    if (covers_p && !is_on_raised) return 0;
    nearest = squared_distance(land_cover, entry, p, nearest);
  }
  // edges in other buckets may be nearer still
  const double near_m = std::sqrt(nearest);
  const BucketRange range = land_cover.range({{p.x - near_m, p.y - near_m}, {p.x + near_m, p.y + near_m}});
  for (int row = range.first_row; row <= range.last_row; ++row)
    for (int column = range.first_column; column <= range.last_column; ++column) {
      const std::span<const BucketEntry> entries = entries_at(land_cover, column, row);
      if (entries.empty() || (column == own_column && row == own_row)) continue;
      if (squared_distance(land_cover, column, row, p) >= nearest) continue;
      for (const BucketEntry& entry : entries) {
        if (entry.priority < priority && !entry.is_raised) break;
        if (entry.priority < priority) continue;
        nearest = squared_distance(land_cover, entry, p, nearest);
      }
    }
  return nearest < squared(search_radius_m) ? std::sqrt(nearest) : search_radius_m;
}

}  // namespace citykiln::ground
