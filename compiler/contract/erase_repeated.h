// Removes consecutive duplicates from a vector.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace citykiln {

/// Keeps the first of consecutive elements with equal keys. O(n).
/// @param key  A member or function whose values are compared.
/// clang 14 cannot compile this library's std::ranges::unique.
template <typename T, typename Key>
void erase_repeated(std::vector<T>& all, Key key) {
  const auto alike = [&](const T& a, const T& b) { return std::invoke(key, a) == std::invoke(key, b); };
  all.erase(std::unique(all.begin(), all.end(), alike), all.end());
}

/// Sorts and leaves each value once. O(n log n).
template <typename T>
void sort_unique(std::vector<T>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

}  // namespace citykiln
