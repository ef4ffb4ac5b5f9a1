#include "compiler/edits/with_edits.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "compiler/edits/added_elements.h"
#include "compiler/edits/edited_areas.h"
#include "compiler/edits/edited_tags.h"
#include "compiler/edits/find_matches.h"
#include "compiler/edits/moved_nodes.h"
#include "compiler/edits/with_strings.h"

namespace citykiln::edits {
namespace {

using source::OsmData;

source::Range& tags_of_match(OsmData& map, const Match& match) {
  if (match.id.type == OsmType::kNode) return map.nodes[match.index].tags;
  return match.id.type == OsmType::kWay ? map.ways[match.index].tags : map.relations[match.index].tags;
}

// Changes the tags of nodes, ways and relations.
void change_tags(OsmData& map, const Edits& edits, std::span<const Match> matches) {
  for (const Match& match : matches)
    if (match.index != kNoTags && changes_tags(edits, match)) {
      source::Range& tags = tags_of_match(map, match);
      tags = add_changed_tags(map, tags, edits, match);
    }
}

std::vector<bool> ways_that_are_areas(const OsmData& map, std::span<const Match> matches) {
  std::vector<bool> are(matches.size());
  for (std::size_t i = 0; i < matches.size(); ++i)
    are[i] = matches[i].id.type == OsmType::kWay && describes_area(map, map.ways[matches[i].index]);
  return are;
}

// Makes nodes of those that had no tags and have some now.
std::vector<AddedElement> add_tagged_nodes(OsmData& map, const Edits& edits, std::span<const Match> matches) {
  std::vector<AddedElement> added;
  std::vector<source::Node> nodes;
  for (const Match& match : matches) {
    if (match.index != kNoTags || !changes_tags(edits, match) || is_dropped(edits, match)) continue;
    const auto at = std::ranges::find(map.way_nodes, match.id.id, &source::NodeRef::id)->at;
    const source::Range tags = add_changed_tags(map, {}, edits, match);
    if (tags.count == 0) continue;
    nodes.push_back({match.id.id, at, tags}), added.push_back({match.id, at, match.lines.front()});
  }
  const auto old_count = static_cast<std::ptrdiff_t>(map.nodes.size());
  std::ranges::move(nodes, std::back_inserter(map.nodes));
  std::ranges::inplace_merge(map.nodes, map.nodes.begin() + old_count, {}, &source::Node::id);
  return added;
}

template <typename Object>
void erase_ids(std::vector<Object>& objects, const std::set<OsmId>& ids, OsmType type) {
  std::erase_if(objects, [&](const Object& object) { return ids.contains({type, object.id}); });
}

void drop_elements(OsmData& map, const Edits& edits, std::span<const Match> matches) {
  std::set<OsmId> dropped;
  for (const Match& match : matches)
    if (is_dropped(edits, match)) dropped.insert(match.id);
  if (dropped.empty()) return;
  erase_ids(map.nodes, dropped, OsmType::kNode);
  erase_ids(map.ways, dropped, OsmType::kWay);
  erase_ids(map.relations, dropped, OsmType::kRelation);
}

// Counts the elements in the ledger. Nodes that have no tags, before and after, are no elements of the map.
void count_elements(const Edits& edits, std::span<const Match> matches, std::span<const AddedElement> added,
                    Report& report) {
  Account& account = report.account("edits", "element");
  for (const Match& match : matches) {
    if (match.index == kNoTags || !report.counts(match.id)) continue;
    ++account.in;
    if (is_dropped(edits, match))
      ++account.dropped[Code::kDroppedByEdit];
    else
      ++account.out;
  }
  for (const AddedElement& each : added)
    if (report.counts(each.id)) ++account.split, ++account.out;
}

// Lets the report of a region count what is added in it.
void own_added(std::span<const AddedElement> added, const source::OwnsPlace& owns, Report& report) {
  if (!owns) return;
  std::vector<OsmId> owned;
  for (const AddedElement& each : added)
    if (owns(each.at.lon_deg(), each.at.lat_deg())) owned.push_back(each.id);
  report.count_also(std::move(owned));
}

std::vector<bool> lines_with_effect(const Edits& edits, std::span<const Match> matches,
                                    std::span<const AddedElement> added) {
  std::vector<bool> had_effect(edits.lines.size());
  for (const Match& match : matches)
    for (const std::uint32_t line : match.lines) had_effect[line] = true;
  for (const AddedElement& each : added) had_effect[each.line] = true;
  return had_effect;
}

}  // namespace

EditedMap with_edits(OsmData map, const Edits& edits, Report& report, const source::OwnsPlace& owns) {
  map = with_strings_of(edits, std::move(map));
  const std::vector<Match> matches = find_matches(map, edits);
  std::vector<AddedElement> added = elements_to_add(map, edits);
  const std::vector<bool> had_effect = lines_with_effect(edits, matches, added);

  const NodeMoves moves = moved_nodes(map, edits, matches);
  const std::vector<bool> were_areas = ways_that_are_areas(map, matches);
  change_tags(map, edits, matches);
  change_areas(map, edits, matches, were_areas, report);
  move_areas(map, moves, move_nodes(map, moves), report);

  // from here on the indices of matches do not hold
  const std::vector<AddedElement> tagged = add_tagged_nodes(map, edits, matches);
  // a way may begin at a node that is dropped
  add_elements(map, edits, added, report);
  drop_elements(map, edits, matches);
  added.insert(added.end(), tagged.begin(), tagged.end());
  own_added(added, owns, report);
  count_elements(edits, matches, added, report);
  return {std::move(map), had_effect};
}

void report_lines(const Edits& edits, const std::vector<bool>& had_effect, Report& report) {
  assert(had_effect.size() == edits.lines.size());
  Account& account = report.account("edits", "line");
  for (std::size_t i = 0; i < edits.lines.size(); ++i) {
    ++account.in;
    if (had_effect[i]) {
      ++account.out;
      continue;
    }
    Diagnosis without{.code = Code::kEditWithoutEffect, .object = {}};
    without.tag = place_text(edits, edits.lines[i]);
    report.drop(account, without);
  }
}

}  // namespace citykiln::edits
