#include "compiler/edits/with_strings.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::edits {
namespace {

// The texts of edits that a map does not have, sorted.
std::vector<std::string> new_texts(const Edits& edits, const source::OsmData& map) {
  std::vector<std::string> texts;
  const auto add = [&](const std::string& text) {
    if (!std::ranges::binary_search(map.strings, text)) texts.push_back(text);
  };
  for (const Edit& edit : edits.lines) {
    for (const auto& [key, value] : edit.changes.set) add(key), add(value);
    if (edit.added)
      for (const auto& [key, value] : edit.added->tags) add(key), add(value);
  }
  sort_unique(texts);
  return texts;
}

}  // namespace

source::OsmData with_strings_of(const Edits& edits, source::OsmData map) {
  std::vector<std::string> texts = new_texts(edits, map);
  if (texts.empty()) return map;
  std::vector<std::uint32_t> places(map.strings.size());
  for (std::size_t i = 0, before = 0; i < places.size(); ++i) {
    while (before < texts.size() && texts[before] < map.strings[i]) ++before;
    places[i] = static_cast<std::uint32_t>(i + before);
  }
  std::vector<std::string> strings;
  strings.reserve(map.strings.size() + texts.size());
  std::merge(std::move_iterator(map.strings.begin()), std::move_iterator(map.strings.end()),
             std::move_iterator(texts.begin()), std::move_iterator(texts.end()), std::back_inserter(strings));
  map.strings = std::move(strings);
  for (source::Tag& tag : map.tags) tag = {places[tag.key], places[tag.value]};
  for (source::Member& member : map.members) member.role = places[member.role];
  return map;
}

std::uint32_t number_of(const source::OsmData& map, std::string_view text) {
  const auto found = std::ranges::lower_bound(map.strings, text);
  assert(found != map.strings.end() && *found == text);
  return static_cast<std::uint32_t>(found - map.strings.begin());
}

}  // namespace citykiln::edits
