#include "compiler/edits/edited_tags.h"

#include <algorithm>
#include <map>
#include <vector>

#include "compiler/edits/fits.h"
#include "compiler/edits/with_strings.h"

namespace citykiln::edits {
namespace {

// Values by key, as numbers of texts.
using NumberedTags = std::map<std::uint32_t, std::uint32_t>;

source::Range append(source::OsmData& map, const NumberedTags& tags) {
  const source::Range range{static_cast<std::uint32_t>(map.tags.size()), static_cast<std::uint32_t>(tags.size())};
  for (const auto& [key, value] : tags) map.tags.push_back({key, value});
  return range;
}

void change(const source::OsmData& map, const Changes& changes, NumberedTags& tags) {
  for (const std::string& pattern : changes.removed)
    std::erase_if(tags, [&](const auto& tag) { return fits_pattern(pattern, map.strings[tag.first]); });
  for (const auto& [key, value] : changes.set) tags[number_of(map, key)] = number_of(map, value);
}

}  // namespace

bool changes_tags(const Edits& edits, const Match& match) {
  return std::ranges::any_of(match.lines, [&](std::uint32_t line) { return edits.lines[line].changes.changes_tags(); });
}

bool is_dropped(const Edits& edits, const Match& match) {
  return std::ranges::any_of(match.lines, [&](std::uint32_t line) { return edits.lines[line].changes.is_dropped; });
}

source::Range add_changed_tags(source::OsmData& map, source::Range tags, const Edits& edits, const Match& match) {
  NumberedTags changed;
  for (const source::Tag& tag : map.tags_of(tags)) changed.emplace(tag.key, tag.value);
  for (const std::uint32_t line : match.lines) change(map, edits.lines[line].changes, changed);
  return append(map, changed);
}

source::Range add_tags(source::OsmData& map, std::span<const std::pair<std::string, std::string>> tags) {
  NumberedTags numbered;
  for (const auto& [key, value] : tags) numbered[number_of(map, key)] = number_of(map, value);
  return append(map, numbered);
}

}  // namespace citykiln::edits
