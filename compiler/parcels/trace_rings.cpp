#include "compiler/parcels/trace_rings.h"

#include <algorithm>
#include <tuple>

namespace citykiln::parcels {
namespace {

struct RegionEdge {
  std::uint32_t region = 0;
  GridPoint from, to;
  Border border;
};

bool region_edge_before(const RegionEdge& a, const RegionEdge& b) {
  return std::tie(a.region, a.from, a.to) < std::tie(b.region, b.from, b.to);
}

// True if u comes before v in clockwise order from `start`. All three directions must differ.
bool is_first_clockwise(GridPoint start, GridPoint u, GridPoint v) {
  const auto cross = [](GridPoint p, GridPoint q) { return p.x * q.y - p.y * q.x; };
  const auto half = [&](GridPoint p) {
    const std::int64_t c = cross(start, p);
    return c < 0 ? 0 : c > 0 ? 2 : start.x * p.x + start.y * p.y < 0 ? 1 : 3;
  };
  const int hu = half(u), hv = half(v);
  return hu != hv ? hu < hv : cross(u, v) < 0;
}

GridPoint minus(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y}; }

class RingTracer {
 public:
  RingTracer(std::vector<RegionEdge> edges, const std::vector<GridPoint>& dropped)
      : edges_(std::move(edges)), is_walked_(edges_.size()), dropped_(dropped) {}

  void trace(std::vector<std::vector<TracedRing>>& rings) {
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (!is_walked_[i]) split(walk(i), rings[edges_[i].region]);
  }

 private:
  // The edge that bounds the same corner of the region.
  std::size_t next_after(const RegionEdge& edge) const {
    const RegionEdge key{edge.region, edge.to, {INT64_MIN, INT64_MIN}, {}};
    const GridPoint back = minus(edge.from, edge.to);
    std::size_t best = edges_.size();
    for (auto i = static_cast<std::size_t>(std::ranges::lower_bound(edges_, key, region_edge_before) - edges_.begin());
         i < edges_.size() && edges_[i].region == edge.region && edges_[i].from == edge.to; ++i)
      if (!is_walked_[i] && (best == edges_.size() ||
                             is_first_clockwise(back, minus(edges_[i].to, edge.to), minus(edges_[best].to, edge.to))))
        best = i;
    return best;
  }

  std::vector<std::size_t> walk(std::size_t start) {
    std::vector<std::size_t> path;
    for (std::size_t i = start; i < edges_.size(); i = next_after(edges_[i])) {
      is_walked_[i] = true;
      path.push_back(i);
      if (edges_[i].to == edges_[start].from) break;
    }
    return path;
  }

  // Splits a path that returns to a point into rings that touch there.
  void split(const std::vector<std::size_t>& path, std::vector<TracedRing>& rings) const {
    std::vector<std::size_t> open;
    std::vector<std::pair<GridPoint, std::size_t>> places;  // sorted: points of `open` and their positions
    for (const std::size_t i : path) {
      const GridPoint p = edges_[i].from;
      auto at = std::ranges::lower_bound(places, p, {}, &std::pair<GridPoint, std::size_t>::first);
      if (at != places.end() && at->first == p) {
        const std::size_t first = at->second;
        rings.push_back(ring_of(std::span(open).subspan(first)));
        open.resize(first);
        std::erase_if(places, [&](const auto& place) { return place.second >= first; });
        at = std::ranges::lower_bound(places, p, {}, &std::pair<GridPoint, std::size_t>::first);
      }
      places.insert(at, {p, open.size()});
      open.push_back(i);
    }
    if (!open.empty()) rings.push_back(ring_of(open));
  }

  // Begins at the ring's lowest point.
  TracedRing ring_of(std::span<const std::size_t> indices) const {
    TracedRing ring;
    const std::size_t n = indices.size();
    std::size_t first = 0;
    for (std::size_t k = 1; k < n; ++k)
      if (edges_[indices[k]].from < edges_[indices[first]].from) first = k;
    for (std::size_t k = 0; k < n; ++k) {
      const RegionEdge& edge = edges_[indices[(first + k) % n]];
      if (std::ranges::binary_search(dropped_, edge.from)) continue;
      ring.points.push_back(edge.from);
      ring.borders.push_back(edge.border);
    }
    return ring;
  }

  std::vector<RegionEdge> edges_;
  std::vector<bool> is_walked_;
  const std::vector<GridPoint>& dropped_;
};

}  // namespace

std::vector<std::vector<TracedRing>> trace_rings(const Faces& faces, const std::vector<std::uint32_t>& regions,
                                                 std::uint32_t region_count, const std::vector<GridPoint>& dropped) {
  std::vector<RegionEdge> edges;
  for (const FaceEdge& edge : faces.edges) {
    const std::uint32_t region = regions[edge.face];
    if (region != kNoIndex && (edge.beyond == kNoIndex || regions[edge.beyond] != region))
      edges.push_back({region, edge.from, edge.to, edge.border});
  }
  std::ranges::sort(edges, region_edge_before);
  std::vector<std::vector<TracedRing>> rings(region_count);
  RingTracer(std::move(edges), dropped).trace(rings);
  for (std::vector<TracedRing>& of_region : rings) std::ranges::sort(of_region, {}, &TracedRing::points);
  return rings;
}

std::int64_t twice_area(const TracedRing& ring) {
  std::int64_t sum = 0;
  const GridPoint corner = ring.points.front();
  for (std::size_t i = 0, j = ring.points.size() - 1; i < ring.points.size(); j = i++)
    sum += turn(corner, ring.points[j], ring.points[i]);
  return sum;
}

}  // namespace citykiln::parcels
