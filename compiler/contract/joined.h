// Joins two lists into one that is sorted.
#pragma once

#include <algorithm>
#include <vector>

namespace citykiln {

/// Returns the objects of both lists, sorted by key(object). Objects with equal keys have no fixed order. O(n log n).
template <typename Object, typename Key>
std::vector<Object> joined(std::vector<Object> first, const std::vector<Object>& second, Key key) {
  first.insert(first.end(), second.begin(), second.end());
  std::ranges::sort(first, {}, key);
  return first;
}

}  // namespace citykiln
