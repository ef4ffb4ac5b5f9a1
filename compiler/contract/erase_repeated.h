// Removes repeated elements from a vector.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace citykiln {

/// Erases all but the first of consecutive elements with equal keys. O(n). (clang 14 cannot compile std::ranges::unique
/// of this library.)
/// @param key  A member or function whose values are compared.
template <typename T, typename Key>
void erase_repeated(std::vector<T>& all, Key key) {
  const auto alike = [&](const T& a, const T& b) { return std::invoke(key, a) == std::invoke(key, b); };
  all.erase(std::unique(all.begin(), all.end(), alike), all.end());
}

/// Sorts the elements and keeps one of each value. O(n log n).
template <typename T>
void sort_unique(std::vector<T>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

}  // namespace citykiln
