// Disjoint sets of numbers, which are joined step by step (union-find with path halving).
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <vector>

namespace citykiln {

/// Sets of the numbers below size(). The lowest number of a set represents it, so results do not depend on the order of
/// joining. find() and join(): O(log size()) amortised, since sets are not joined by size.
class DisjointSets {
 public:
  /// @param size  The count of numbers; at first each is a set of its own.
  explicit DisjointSets(std::size_t size = 0) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0u); }

  std::size_t size() const { return parents_.size(); }
  /// Adds the number size() as a set of its own.
  void add() { parents_.push_back(static_cast<std::uint32_t>(size())); }

  /// Returns the lowest number of the set of i.
  std::uint32_t find(std::uint32_t i) {
    assert(i < size());
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i), j = find(j);
    parents_[std::max(i, j)] = std::min(i, j);
  }
  /// Returns for each number the lowest number of its set.
  std::vector<std::uint32_t> lowest() {
    for (std::uint32_t i = 0; i < size(); ++i) parents_[i] = find(i);
    return parents_;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace citykiln
