// Tags: put together piece by piece, and read.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "compiler/invent/invented_map.h"

namespace citykiln::invent {

/// Adds a tag, or replaces its value. Tags must be sorted by key, and stay so. An empty value changes nothing.
inline void set_tag(Tags& tags, std::string key, std::string value) {
  if (value.empty()) return;
  const auto at = std::ranges::lower_bound(tags, key, {}, &std::pair<std::string, std::string>::first);
  if (at != tags.end() && at->first == key)
    at->second = std::move(value);
  else
    tags.insert(at, {std::move(key), std::move(value)});
}

/// Returns the value of a key; "" if the tags lack it.
inline std::string_view value_in(const Tags& tags, std::string_view key) {
  const auto tag = std::ranges::find(tags, key, &std::pair<std::string, std::string>::first);
  return tag == tags.end() ? std::string_view() : tag->second;
}

/// Returns tags of pairs in any order.
inline Tags tags_of(std::initializer_list<std::pair<const char*, std::string>> pairs) {
  Tags tags;
  for (const auto& [key, value] : pairs) set_tag(tags, key, value);
  return tags;
}

}  // namespace citykiln::invent
