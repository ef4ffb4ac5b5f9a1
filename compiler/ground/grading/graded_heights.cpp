#include "compiler/ground/grading/graded_heights.h"

#include <bit>
#include <cstdint>

namespace citykiln::ground {

// Knuth's multiplicative hashing, as for normals: what tells neighbours apart is high in their bits, and must come
// down.
std::size_t GradedHeights::PlaceHash::operator()(Vec2 place) const {
  const std::uint64_t mixed = std::bit_cast<std::uint64_t>(place.x) * 0x9e3779b97f4a7c15u +
                              std::bit_cast<std::uint64_t>(place.y) * 0xc2b2ae3d27d4eb4fu;
  return static_cast<std::size_t>(mixed ^ mixed >> 29);
}

const HeightSample& GradedHeights::at(Vec2 p) {
  const auto [found, is_new] = known_.try_emplace(p);
  if (is_new) found->second = sample_heights(graded_, p);
  return found->second;
}

Heights GradedHeights::uncached_at(Vec2 p) const {
  const auto found = known_.find(p);
  return found == known_.end() ? heights_at(graded_, p) : found->second.heights;
}

}  // namespace citykiln::ground
