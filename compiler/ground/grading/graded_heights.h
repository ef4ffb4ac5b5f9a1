// A cache of heights of the graded terrain (the terrain after roads and water have cut into it) for one cell. Rings
// share corners and grading lines share ends, and both are sampled again when they are triangulated.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <unordered_map>

#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::ground {

/// Hashes a place (Knuth's multiplicative hashing). Neighbouring places differ in few bits, of doubles in high ones;
/// the odd factors and the shift spread them over all bits.
inline std::size_t hash_of_place(std::uint64_t x, std::uint64_t y) {
  const std::uint64_t mixed = x * 0x9e3779b97f4a7c15u + y * 0xc2b2ae3d27d4eb4fu;
  return static_cast<std::size_t>(mixed ^ mixed >> 29);
}

/// The cache. Refers to the graded terrain, which must outlive it. Grows with the number of different places.
class GradedHeights {
 public:
  explicit GradedHeights(const GradedTerrain& graded) : graded_(graded) {}

  /// Returns sample_heights() at p, equal in every bit. The reference stays valid. O(1) for places sampled before.
  const HeightSample& at(Vec2 p) {
    const auto [found, is_new] = samples_.try_emplace(p);
    if (is_new) found->second = sample_heights(graded_, p);
    return found->second;
  }

  /// Returns the heights at p without storing them, for places that are sampled once.
  Heights uncached_at(Vec2 p) const {
    const auto found = samples_.find(p);
    return found == samples_.end() ? heights_at(graded_, p) : found->second.heights;
  }

  const GradedTerrain& graded() const { return graded_; }

 private:
  struct PlaceHash {
    std::size_t operator()(Vec2 p) const {
      return hash_of_place(std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y));
    }
  };
  const GradedTerrain& graded_;
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::unordered_map<Vec2, HeightSample, PlaceHash> samples_{&memory_};
};

}  // namespace citykiln::ground
