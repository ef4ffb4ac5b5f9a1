// The rules of libosmium's AssemblerLegacy (osmium/area/assembler_legacy.hpp), with one difference: a closed outer way
// remains an area if the relation has tags of its own, unless both say that they are one thing.
#include "compiler/source/areas/old_style_multipolygons.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "compiler/source/areas/assemble_areas.h"
#include "compiler/source/areas/bodies.h"

namespace citykiln::source {
namespace {

using TagText = std::pair<std::uint32_t, std::uint32_t>;

// The descriptive tags as sorted pairs of key and value.
std::vector<TagText> description_of(const OsmData& data, Range tags) {
  std::vector<TagText> words;
  for (const Tag& tag : data.tags_of(tags)) {
    if (is_descriptive(data.strings[tag.key])) words.emplace_back(tag.key, tag.value);
  }
  std::sort(words.begin(), words.end());
  return words;
}

const Way* find_way(const OsmData& data, std::int64_t id) {
  const auto found = std::lower_bound(data.ways.begin(), data.ways.end(), id,
                                      [](const Way& way, std::int64_t i) { return way.id < i; });
  return found != data.ways.end() && found->id == id ? &*found : nullptr;
}

const Relation* find_relation(const OsmData& data, std::int64_t id) {
  const auto found = std::lower_bound(data.relations.begin(), data.relations.end(), id,
                                      [](const Relation& relation, std::int64_t i) { return relation.id < i; });
  return found != data.relations.end() && found->id == id ? &*found : nullptr;
}

struct MemberWays {
  std::vector<const Way*> outer, inner;
};

MemberWays ways_of(const OsmData& data, const Relation& relation) {
  MemberWays ways;
  for (std::uint32_t i = 0; i < relation.members.count; ++i) {
    const Member& member = data.members[relation.members.first + i];
    const Way* way = member.object.type == OsmType::kWay ? find_way(data, member.object.id) : nullptr;
    if (way) (data.strings[member.role] == "inner" ? ways.inner : ways.outer).push_back(way);
  }
  return ways;
}

std::vector<TagText> common_description(const OsmData& data, const std::vector<const Way*>& ways) {
  if (ways.empty()) return {};
  std::vector<TagText> common = description_of(data, ways.front()->tags);
  for (const Way* way : ways) {
    const std::vector<TagText> theirs = description_of(data, way->tags);
    std::erase_if(common, [&](TagText words) { return !std::binary_search(theirs.begin(), theirs.end(), words); });
  }
  return common;
}

// Replaces the area's tags by its own and `more`.
void add_area_tags(OsmData& data, Area& area, const std::vector<TagText>& more) {
  const auto first = static_cast<std::uint32_t>(data.tags.size());
  for (std::uint32_t i = 0; i < area.tags.count; ++i) data.tags.push_back(Tag(data.tags[area.tags.first + i]));
  for (const auto& [key, value] : more) data.tags.push_back({key, value});
  area.tags = {first, static_cast<std::uint32_t>(data.tags.size()) - first};
  const auto by_words = [](const Tag& a, const Tag& b) { return TagText{a.key, a.value} < TagText{b.key, b.value}; };
  std::sort(data.tags.begin() + first, data.tags.end(), by_words);
}

// Words for one thing: two elements with words of one row describe it twice.
constexpr std::string_view kSameThings[][4] = {
    {"natural=water", "landuse=reservoir", "landuse=basin", "waterway=riverbank"}, {"natural=wood", "landuse=forest"}};

bool are_same_thing(std::string_view a, std::string_view b) {
  return a == b || std::ranges::any_of(kSameThings, [&](const auto& words) {
           return std::ranges::find(words, a) != std::end(words) && std::ranges::find(words, b) != std::end(words);
         });
}

// The tags that say what an element is, as "key=value"; of buildings the key alone.
std::vector<std::string> things_of(const OsmData& data, Range tags) {
  std::vector<std::string> things;
  for (const Tag& tag : data.tags_of(tags)) {
    const std::string& key = data.strings[tag.key];
    const std::string& value = data.strings[tag.value];
    if (!has_body(key, value) || value == "no") continue;
    things.push_back(key == "building" ? key : key + "=" + value);
  }
  return things;
}

// The tags of a way whose keys the area does not have.
std::vector<TagText> missing_tags(const OsmData& data, const Area& area, const Way& way) {
  std::vector<TagText> missing = description_of(data, way.tags);
  std::erase_if(missing, [&](TagText words) {
    return std::ranges::any_of(data.tags_of(area.tags), [&](const Tag& tag) { return tag.key == words.first; });
  });
  return missing;
}

// Merges the outer ways that describe the area once more. The area takes the tags that it lacks from a single one.
void merge_described_twice(OsmData& data, Area& area, const std::vector<const Way*>& outer,
                           std::set<std::int64_t>& merged_ways) {
  for (const Way* way : outer) {
    if (!are_one_thing(data, way->tags, area.tags)) continue;
    merged_ways.insert(way->id);
    if (outer.size() == 1) add_area_tags(data, area, missing_tags(data, area, *way));
  }
}

// Completes the tags of one multipolygon and collects the ways whose areas it replaces.
void merge(OsmData& data, Area& area, const Relation& relation, std::set<std::int64_t>& merged_ways) {
  const MemberWays ways = ways_of(data, relation);
  std::vector<TagText> description = description_of(data, area.tags);
  if (description.empty()) {
    description = common_description(data, ways.outer);
    if (description.empty()) return;
    add_area_tags(data, area, description);
    for (const Way* way : ways.outer) {
      if (description_of(data, way->tags) == description) merged_ways.insert(way->id);
    }
  } else {
    merge_described_twice(data, area, ways.outer, merged_ways);
  }
  for (const Way* way : ways.inner) {
    if (description_of(data, way->tags) == description) merged_ways.insert(way->id);
  }
}

}  // namespace

bool are_one_thing(const OsmData& data, Range one, Range two) {
  const std::vector<std::string> a = things_of(data, one), b = things_of(data, two);
  return std::ranges::any_of(a, [&](const std::string& thing) {
    return std::ranges::any_of(b, [&](const std::string& other) { return are_same_thing(thing, other); });
  });
}

void merge_old_style_multipolygons(OsmData& data, Report& report) {
  assert(std::ranges::is_sorted(data.areas, {}, &Area::from));
  assert(std::ranges::is_sorted(data.ways, {}, &Way::id));
  assert(std::ranges::is_sorted(data.relations, {}, &Relation::id));
  std::set<std::int64_t> merged_ways;
  for (Area& area : data.areas) {
    if (area.from.type != OsmType::kRelation) continue;
    const Relation* relation = find_relation(data, area.from.id);
    if (relation && data.value_of(relation->tags, "type") == "multipolygon") merge(data, area, *relation, merged_ways);
  }
  Account& account = report.account("source", "area");
  const auto is_merged = [&](const Area& area) {
    return area.from.type == OsmType::kWay && merged_ways.contains(area.from.id);
  };
  for (const Area& area : data.areas)
    if (is_merged(area) && report.counts(area.from)) ++account.merged, --account.out;
  std::erase_if(data.areas, is_merged);
}

}  // namespace citykiln::source
