// Two lists of recipes as one.
#pragma once

#include <algorithm>
#include <vector>

namespace citykiln {

/// Returns two lists as one, sorted by a key: a function of an object.
template <typename Object, typename Key>
std::vector<Object> joined(std::vector<Object> first, const std::vector<Object>& second, Key key) {
  first.insert(first.end(), second.begin(), second.end());
  std::ranges::sort(first, {}, key);
  return first;
}

}  // namespace citykiln
