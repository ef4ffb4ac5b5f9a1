// An unordered set of grid points with constant-time lookup.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"

namespace citykiln {

/// A hash table with open addressing, at most half full.
class GridPointSet {
 public:
  explicit GridPointSet(std::span<const GridPoint> points) {
    slots_.resize(std::bit_ceil(2 * points.size() + 2), kFree);
    for (const GridPoint p : points) insert(p);
  }

  bool contains(GridPoint p) const { return slots_[slot_of(p)] == p; }

  /// Adds a point unless it is in the set. O(1) on average.
  void insert(GridPoint p) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    GridPoint& slot = slots_[slot_of(p)];
    if (slot == kFree) slot = p, ++count_;
  }

 private:
  static constexpr GridPoint kFree{std::numeric_limits<std::int64_t>::min(), 0};

  // Multiplies by odd numbers and takes the upper bits, which depend on all lower ones (Knuth, TAOCP 3, 6.4).
  std::size_t first_slot(GridPoint p) const {
    const std::uint64_t mixed =
        static_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(p.y) * 0xc2b2ae3d27d4eb4fu;
    return (mixed ^ (mixed >> 32)) * 0x9e3779b97f4a7c15u >> (64 - std::countr_zero(slots_.size()));
  }

  // Returns the slot that holds p, or the free one where it would go.
  std::size_t slot_of(GridPoint p) const {
    std::size_t slot = first_slot(p);
    while (slots_[slot] != p && slots_[slot] != kFree) slot = (slot + 1) % slots_.size();
    return slot;
  }

  void grow() {
    std::vector<GridPoint> old(2 * slots_.size(), kFree);
    old.swap(slots_);
    for (const GridPoint p : old)
      if (p != kFree) slots_[slot_of(p)] = p;
  }

  std::vector<GridPoint> slots_;
  std::size_t count_ = 0;
};

}  // namespace citykiln
