// Tags, put together piece by piece.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/invent/invented_map.h"

namespace citykiln::invent {

/// Sets a tag and keeps tags sorted by key. An empty value adds nothing.
inline void set_tag(Tags& tags, std::string key, std::string value) {
  if (value.empty()) return;
  const auto at = std::ranges::lower_bound(tags, key, {}, &std::pair<std::string, std::string>::first);
  if (at != tags.end() && at->first == key)
    at->second = std::move(value);
  else
    tags.insert(at, {std::move(key), std::move(value)});
}

/// Returns tags of pairs in any order.
inline Tags tags_of(std::initializer_list<std::pair<const char*, std::string>> pairs) {
  Tags tags;
  for (const auto& [key, value] : pairs) set_tag(tags, key, value);
  return tags;
}

}  // namespace citykiln::invent
