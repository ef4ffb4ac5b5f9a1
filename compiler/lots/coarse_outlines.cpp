#include "compiler/lots/coarse_outlines.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "compiler/contract/equal_span.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/lots/recipe.h"

namespace citykiln::lots {
namespace {

// An edge as seen from one of its ends.
struct Spoke {
  Vec2 end, other;
  auto operator<=>(const Spoke&) const = default;
};

// The spokes of all edges, sorted; an edge of two polygons is there twice.
std::vector<Spoke> spokes_of(std::span<const Polygon> polygons) {
  std::vector<Spoke> spokes;
  for (const Polygon& polygon : polygons)
    for (const Ring* ring : rings_of(polygon))
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
        spokes.push_back({a, b}), spokes.push_back({b, a});
      }
  std::ranges::sort(spokes);
  return spokes;
}

// True for a point where a chain ends: it has not two edges, or these are not of the same number of polygons.
bool is_node(const std::vector<Spoke>& spokes, Vec2 p) {
  const auto own = equal_span(spokes, p, &Spoke::end);
  const auto first = static_cast<std::size_t>(std::ranges::count(own, own.front()));
  const auto last = static_cast<std::size_t>(std::ranges::count(own, own.back()));
  return own.front() == own.back() || first != last || first + last != own.size();
}

// Marks the points of a chain that are kept between two kept ones.
void keep_between(std::span<const Vec2> chain, std::size_t first, std::size_t last, std::vector<bool>& kept) {
  double most_m = kOutlineTolerance_m;
  std::size_t worst = first;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double off_m = distance_to_segment(chain[first], chain[last], chain[i]); off_m > most_m)
      most_m = off_m, worst = i;
  if (worst == first) return;
  kept[worst] = true;
  keep_between(chain, first, worst, kept), keep_between(chain, worst, last, kept);
}

// The points of a chain that remain, in its order. The result for the reversed chain is the reversed result.
std::vector<Vec2> coarse_chain(std::vector<Vec2> chain) {
  const bool is_turned = std::pair(chain.back(), *(chain.end() - 2)) < std::pair(chain.front(), chain[1]);
  if (is_turned) std::ranges::reverse(chain);
  std::vector<bool> kept(chain.size());
  kept.front() = kept.back() = true;
  keep_between(chain, 0, chain.size() - 1, kept);
  std::vector<Vec2> coarse;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (kept[i]) coarse.push_back(chain[i]);
  if (is_turned) std::ranges::reverse(coarse);
  return coarse;
}

// The places in a ring where its chains end: its nodes; without any, its least point and the one farthest from it.
std::vector<std::size_t> chain_ends(const Ring& ring, const std::vector<Spoke>& spokes) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (is_node(spokes, ring[i])) ends.push_back(i);
  if (!ends.empty()) return ends;
  const auto least = std::ranges::min_element(ring);
  const auto farthest = std::ranges::max_element(ring, {}, [&](Vec2 p) { return std::pair(distance(p, *least), p); });
  ends = {static_cast<std::size_t>(least - ring.begin()), static_cast<std::size_t>(farthest - ring.begin())};
  std::ranges::sort(ends);
  return ends;
}

Ring coarse_ring(const Ring& ring, const std::vector<Spoke>& spokes) {
  if (ring.size() < 3) return {};
  const std::vector<std::size_t> ends = chain_ends(ring, spokes);
  Ring coarse;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::size_t last = k + 1 < ends.size() ? ends[k + 1] : ends[0] + ring.size();
    std::vector<Vec2> chain;
    for (std::size_t i = ends[k]; i <= last; ++i) chain.push_back(ring[i % ring.size()]);
    for (const Vec2 p : coarse_chain(std::move(chain))) coarse.push_back(snapped_to(kOutlineStep_m, p));
  }
  coarse = without_repeats(coarse);
  return coarse.size() < 3 ? Ring{} : coarse;
}

}  // namespace

std::vector<Polygon> coarse_outlines(std::span<const Polygon> polygons) {
  const std::vector<Spoke> spokes = spokes_of(polygons);
  std::vector<Polygon> coarse;
  for (const Polygon& polygon : polygons) {
    Polygon& own = coarse.emplace_back(Polygon{coarse_ring(polygon.outer, spokes), {}});
    if (own.outer.empty()) continue;
    for (const Ring& hole : polygon.holes)
      if (Ring ring = coarse_ring(hole, spokes); !ring.empty()) own.holes.push_back(std::move(ring));
  }
  return coarse;
}

}  // namespace citykiln::lots
