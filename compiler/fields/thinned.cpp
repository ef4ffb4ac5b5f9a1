#include "compiler/fields/thinned.h"

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/segment.h"

namespace citykiln::fields {
namespace {

constexpr int kThinningRounds = 4;

std::uint64_t rank_of(Vec2 p) {
  const auto step = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v * 128)); };
  return static_cast<std::uint64_t>(stable_id(StableId{step(p.x)}, "thinned", step(p.y)));
}

// True if a point is straight, and has a lower rank than its neighbours, which therefore stay in this round.
bool is_dropped(Vec2 before, Vec2 at, Vec2 after, double within_m) {
  return rank_of(at) < rank_of(before) && rank_of(at) < rank_of(after) &&
         distance_to_segment(before, after, at) < within_m;
}

}  // namespace

Polyline thinned(std::span<const Vec2> line, double within_m) {
  Polyline kept(line.begin(), line.end());
  for (int round = 0; round < kThinningRounds; ++round) {
    Polyline next;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (i == 0 || i + 1 == kept.size() || !is_dropped(kept[i - 1], kept[i], kept[i + 1], within_m))
        next.push_back(kept[i]);
    kept = std::move(next);
  }
  return kept;
}

Ring thinned_ring(std::span<const Vec2> ring, double within_m) {
  Ring kept(ring.begin(), ring.end());
  for (int round = 0; round < kThinningRounds && kept.size() > 4; ++round) {
    Ring next;
    for (std::size_t i = 0, n = kept.size(); i < n; ++i)
      if (!is_dropped(kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n], within_m)) next.push_back(kept[i]);
    kept = std::move(next);
  }
  return kept;
}

}  // namespace citykiln::fields
