#include "grammars/roofs/facet.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace citykiln::roofs {
namespace {

// A part of the ring on the kept side, from where it enters across the line to where it leaves.
struct Chain {
  Ring points;
  double in = 0, out = 0;  // positions of both along the line
};

// The chains of a ring; none if it does not cross the line.
std::vector<Chain> chains_of(const Ring& ring, const Plane& plane) {
  const std::size_t n = ring.size();
  const auto is_kept = [&](std::size_t i) { return plane.at(ring[i % n]) >= 0; };
  const auto crossing = [&](std::size_t i) {
    const Vec2 p = ring[i % n], q = ring[(i + 1) % n];
    return p + (q - p) * (plane.at(p) / (plane.at(p) - plane.at(q)));
  };
  const Vec2 along = left_of(plane.gradient);
  std::vector<Chain> chains;
  for (std::size_t start = 0; start < n; ++start) {
    if (is_kept(start) || !is_kept(start + 1)) continue;
    Chain& chain = chains.emplace_back();
    chain.points.push_back(crossing(start));
    chain.in = dot(along, chain.points.back() - plane.origin);
    std::size_t i = start + 1;
    for (; is_kept(i); ++i) chain.points.push_back(ring[i % n]);
    chain.points.push_back(crossing(i - 1));
    chain.out = dot(along, chain.points.back() - plane.origin);
  }
  return chains;
}

// The chain that follows each chain. Along the line, the inside of the ring is between the first and second crossing,
// the third and fourth, and so on; each such segment leads from the end of one chain to the start of another.
std::vector<std::size_t> followers(const std::vector<Chain>& chains) {
  struct Crossing {
    double at;
    std::size_t chain;
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    crossings.push_back({chains[i].in, 2 * i});
    crossings.push_back({chains[i].out, 2 * i + 1});
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return std::pair(a.at, a.chain) < std::pair(b.at, b.chain); });
  std::vector<std::size_t> next(chains.size());
  std::iota(next.begin(), next.end(), std::size_t{0});
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    std::size_t out = crossings[k].chain, in = crossings[k + 1].chain;
    if (out % 2 == 0) std::swap(out, in);
    if (out % 2 == 1 && in % 2 == 0) next[out / 2] = in / 2;
  }
  return next;
}

}  // namespace

Plane combined(double first, const Plane& a, double second, const Plane& b) {
  return {a.origin, a.gradient * first + b.gradient * second, first * a.offset + second * b.at(a.origin)};
}

Ring clipped(std::span<const Vec2> ring, const Plane& plane) {
  Ring kept;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const Vec2 p = ring[i], q = ring[(i + 1) % n];
    const double zp = plane.at(p), zq = plane.at(q);
    if (zp >= 0) kept.push_back(p);
    if ((zp < 0 && zq > 0) || (zp > 0 && zq < 0)) kept.push_back(p + (q - p) * (zp / (zp - zq)));
  }
  return kept.size() < 3 ? Ring{} : kept;
}

std::vector<Ring> clipped_pieces(const Ring& ring, const Plane& plane) {
  const std::vector<Chain> chains = chains_of(ring, plane);
  if (chains.empty()) return ring.empty() || plane.at(ring.front()) < 0 ? std::vector<Ring>{} : std::vector<Ring>{ring};
  const std::vector<std::size_t> next = followers(chains);
  std::vector<bool> is_used(chains.size());
  std::vector<Ring> pieces;
  for (std::size_t start = 0; start < chains.size(); ++start) {
    if (is_used[start]) continue;
    Ring& piece = pieces.emplace_back();
    for (std::size_t at = start; !is_used[at]; at = next[at]) {
      is_used[at] = true;
      piece.insert(piece.end(), chains[at].points.begin(), chains[at].points.end());
    }
  }
  return pieces;
}

Plane distance_left_of(Vec2 a, Vec2 b) {
  assert(a != b);
  return {a, left_of(unit(b - a)), 0};
}

}  // namespace citykiln::roofs
