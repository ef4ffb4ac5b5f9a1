// The elements of a sorted sequence that have one key.
#pragma once

#include <algorithm>
#include <functional>
#include <span>

namespace citykiln {

/// Returns the elements of the sorted sequence whose key is `key`; empty if there are none. Valid as long as
/// the sequence. O(log n). (clang 14 cannot compile std::ranges::equal_range of this library.)
template <typename Sequence, typename Key, typename KeyOf = std::identity>
auto equal_span(const Sequence& sorted, const Key& key, KeyOf key_of = {}) {
  const auto first = std::ranges::lower_bound(sorted, key, {}, key_of);
  return std::span(first, std::ranges::upper_bound(first, sorted.end(), key, {}, key_of));
}

}  // namespace citykiln
