// Of things that follow each other and are alike, the first stays.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace citykiln {

/// @param key  What makes two alike: a member, or a function. O(n).
/// clang 14 cannot compile std::ranges::unique of this library.
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
