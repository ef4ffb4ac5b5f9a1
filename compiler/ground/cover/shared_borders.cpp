#include "compiler/ground/cover/shared_borders.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/cover/inside_rings.h"

namespace citykiln::ground {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

struct OwnedEdge {
  Vec2 low, high;
  std::uint32_t owner;
  bool runs_up;  // from the lower point to the higher
  auto operator<=>(const OwnedEdge&) const = default;
};

std::vector<OwnedEdge> owned_edges_of(std::span<const LandCoverPolygon> surfaces,
                                      std::span<const std::uint32_t> members) {
  std::vector<OwnedEdge> edges;
  for (std::uint32_t m = 0; m < members.size(); ++m)
    for (const Ring& ring : surfaces[members[m]].rings)
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        edges.push_back({std::min(ring[j], ring[i]), std::max(ring[j], ring[i]), m, ring[j] < ring[i]});
  std::sort(edges.begin(), edges.end());
  return edges;
}

void add_pairs_by_edge(std::span<const OwnedEdge> edges, std::vector<Pair>& pairs) {
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const OwnedEdge &a = edges[i], &b = edges[i + 1];
    if (a.low == b.low && a.high == b.high && a.owner != b.owner) pairs.emplace_back(a.owner, b.owner);
  }
}

bool has_vertex_within(const LandCoverPolygon& surface, const BandedRings& rings) {
  return std::ranges::any_of(surface.rings, [&](const Ring& ring) {
    return std::ranges::any_of(ring, [&](Vec2 p) { return is_inside(rings, p); });
  });
}

void add_pairs_by_overlap(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> members,
                          std::vector<Pair>& pairs) {
  std::vector<BandedRings> rings;
  for (const std::uint32_t m : members) rings.push_back(band_rings(surfaces[m]));
  std::vector<std::uint32_t> from_west(members.size());
  for (std::uint32_t i = 0; i < from_west.size(); ++i) from_west[i] = i;
  std::ranges::stable_sort(from_west, {}, [&](std::uint32_t i) { return rings[i].box.min.x; });
  for (std::size_t i = 0; i < from_west.size(); ++i)
    for (std::size_t j = i + 1; j < from_west.size(); ++j) {
      const std::uint32_t a = from_west[i], b = from_west[j];
      if (rings[b].box.min.x > rings[a].box.max.x) break;
      if (!rings[a].box.touches(rings[b].box)) continue;
      if (has_vertex_within(surfaces[members[a]], rings[b]) || has_vertex_within(surfaces[members[b]], rings[a]))
        pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
}

}  // namespace

std::vector<Edge> edges_between(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> members) {
  const std::vector<OwnedEdge> edges = owned_edges_of(surfaces, members);
  std::vector<Edge> between;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    bool up = false, down = false;
    for (; last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high; ++last)
      (edges[last].runs_up ? up : down) = true;
    if (up && down) between.emplace_back(edges[first].low, edges[first].high);
  }
  return between;
}

std::vector<Pair> shared_borders(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> members) {
  std::vector<Pair> pairs;
  add_pairs_by_edge(owned_edges_of(surfaces, members), pairs);
  add_pairs_by_overlap(surfaces, members, pairs);
  sort_unique(pairs);
  return pairs;
}

std::vector<std::uint32_t> groups_of(std::size_t count, std::span<const Pair> pairs) {
  assert(std::ranges::all_of(pairs, [&](const Pair& p) { return p.first < count && p.second < count; }));
  DisjointSets sets(count);
  for (const auto& [a, b] : pairs) sets.join(a, b);
  return sets.lowest();
}

}  // namespace citykiln::ground
